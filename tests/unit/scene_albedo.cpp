#include "scene/scene_albedo.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr double RADIUS = 6.36e6;

Scene two_colors() { return scene_of({matte({0.8f, 0.4f, 0.2f}), matte({0.2f, 0.2f, 0.2f})}); }

/// Of a scene that stands at the pole, its +Y up.
std::vector<GroundPatch> patches_of(Scene const& scene, double scale = 1, double altitude = 10) {
    glm::dmat4 world_from_scene(glm::scale(glm::dmat4(1), glm::dvec3(scale)));
    world_from_scene[3].y = RADIUS + altitude;
    return ground_patches(scene, world_from_scene, RADIUS);
}

double area_of(std::vector<GroundPatch> const& patches) {
    return std::accumulate(patches.begin(), patches.end(), 0.0, [](double sum, GroundPatch const& p) { return sum + p.area; });
}

glm::vec3 mean_of(std::vector<GroundPatch> const& patches) {
    glm::dvec3 sum(0);
    for (GroundPatch const& patch : patches) sum += patch.area * glm::dvec3(patch.albedo);
    return glm::vec3(sum / area_of(patches));
}

void expect_color(glm::vec3 const& found, glm::vec3 const& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5f) << c;
}

} // namespace

TEST(GroundPatches, cover_level_ground_once) {
    Scene scene = two_colors();
    add_plane(scene, 8, 0, 0);
    add_plane(scene, 8, 1, 0); // above it
    std::vector<GroundPatch> const patches = patches_of(scene, 100);
    EXPECT_EQ(patches.size(), std::size_t(GROUND_PATCHES * GROUND_PATCHES));
    EXPECT_NEAR(area_of(patches), 1600.0 * 1600, 1);
    for (GroundPatch const& patch : patches) EXPECT_NEAR(glm::length(patch.position) - RADIUS, 60, 1);
}

TEST(GroundPatches, count_surfaces_by_their_outline_on_the_map) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);  // level, 4 m^2
    add_quad(scene, {5, 0, 0}, {1, 3, 0}, {0, 0, -1}, 1);  // steep, the same outline
    add_quad(scene, {9, 0, 0}, {0, 1, 0}, {0, 0, -1}, 1);  // a wall has none
    add_quad(scene, {-5, 0, 0}, {1, 0, 0}, {0, 0, 1}, 1);  // nor has a ceiling
    std::vector<GroundPatch> const patches = patches_of(scene);
    EXPECT_NEAR(area_of(patches), 8, 0.5); // where the two quads' borders share a patch with nothing
    // The mean normal is that of areas (0, 4) and (-12, 4).
    double const level = 8 / std::hypot(12, 8), steep = (144 + 32) / std::hypot(12, 8) / std::hypot(12, 4);
    auto const of_slope = [](double color, double open) { return color * open / (1 - color * (1 - open)); };
    glm::vec3 expected;
    for (int c = 0; c < 3; ++c) expected[c] = static_cast<float>(0.5 * (of_slope(0.8 / (1 << c), level) + of_slope(0.2, steep)));
    expect_color(mean_of(patches), expected);
}

TEST(GroundPatches, of_one_slope_are_as_bright_as_it_is) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {8, 0, 0}, {0, 8, -8}, 0);
    expect_color(mean_of(patches_of(scene)), {0.8f, 0.4f, 0.2f});
}

// Slopes of 60 degrees before each other: half of a slope's light goes out, the other half meets a slope again. The series of all
// rounds is A (1/2) (1 + A/2 + ...).
TEST(GroundPatches, of_slopes_before_each_other_are_darker) {
    Scene scene = two_colors();
    for (int i = 0; i < 64; ++i) {
        double const width = 0.5, height = width * std::sqrt(3.0), x = 2 * width * i;
        add_quad(scene, {x, 0, 0}, {0.5 * width, 0.5 * height, 0}, {0, 0, -32}, 0);
        add_quad(scene, {x + width, 0, 0}, {0.5 * width, -0.5 * height, 0}, {0, 0, -32}, 0);
    }
    expect_color(mean_of(patches_of(scene)), {0.4f / 0.6f, 0.2f / 0.8f, 0.1f / 0.9f});
}

TEST(GroundPatches, hold_for_turned_and_mirrored_instances) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);
    scene.instances[0].scene_from_mesh = glm::dmat4(glm::dmat3({-3, 0, 0}, {0, 1, 0}, {0, 0, 2}));
    scene.bounds = scene_bounds(scene);
    EXPECT_NEAR(area_of(patches_of(scene)), 24, 0.1);
    expect_color(mean_of(patches_of(scene)), {0.8f, 0.4f, 0.2f});
}

TEST(GroundPatches, see_colours_where_they_are) {
    Scene scene = two_colors();
    scene.materials[0].base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1);
    Picture picture{.name = "", .width = 14, .height = 14, .rgba = {}};
    for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
        for (int const value : {i % 14 < 7 ? 255 : 0, 188, 0, 255}) picture.rgba.push_back(static_cast<std::uint8_t>(value));
    scene.pictures.push_back(picture);
    scene.materials[0].base_color_texture.picture = 1; // 0 is the black texel
    add_plane(scene, 8);
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv0 = {vertex.position.x / 16 + 0.5f, vertex.position.z / 16 + 0.5f};
    for (GroundPatch const& patch : patches_of(scene)) {
        if (std::abs(patch.position.x) < 1) continue;
        EXPECT_NEAR(patch.albedo.x, patch.position.x < 0 ? 0.5 : 0.0, 1e-5) << patch.position.x;
        EXPECT_NEAR(patch.albedo.y, 0.25f, 2e-3f); // 188 of 255 is half of the light
        EXPECT_EQ(patch.albedo.z, 0);
    }
}

TEST(GroundPatches, leave_out_what_lies_under_the_planets_surface) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);
    add_quad(scene, {5, -20, 0}, {1, 0, 0}, {0, 0, -1}, 1);
    expect_color(mean_of(patches_of(scene)), {0.8f, 0.4f, 0.2f});
}

TEST(GroundPatches, are_none_where_nothing_faces_up) { EXPECT_TRUE(patches_of(Scene{}).empty()); }
