#include "scene/scene_albedo.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

Scene two_colors() { return scene_of({matte({0.8f, 0.4f, 0.2f}), matte({0.2f, 0.2f, 0.2f})}); }

void expect_color(glm::vec3 const& found, glm::vec3 const& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-5f) << c;
}

} // namespace

TEST(SceneAlbedo, counts_surfaces_by_their_outline_on_the_map) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);       // level, 4 m^2
    add_quad(scene, {5, 0, 0}, {1, 3, 0}, {0, 0, -1}, 1);       // steep, the same outline
    expect_color(albedo_from_above(scene), {0.5f, 0.3f, 0.2f});
    add_quad(scene, {9, 0, 0}, {0, 1, 0}, {0, 0, -1}, 1);       // a wall has none
    add_quad(scene, {0, 9, 0}, {1, 0, 0}, {0, 0, 1}, 1);        // nor has a ceiling
    expect_color(albedo_from_above(scene), {0.5f, 0.3f, 0.2f});
}

TEST(SceneAlbedo, holds_for_turned_and_mirrored_instances) {
    Scene scene = two_colors();
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);
    scene.instances[0].scene_from_mesh = glm::dmat4(glm::dmat3({-3, 0, 0}, {0, 1, 0}, {0, 0, 2}));
    expect_color(albedo_from_above(scene), {0.8f, 0.4f, 0.2f});
}

TEST(SceneAlbedo, a_picture_counts_by_its_mean_in_linear_light) {
    Scene scene = two_colors();
    scene.materials[0].base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1);
    Picture picture{.name = "", .width = 14, .height = 14, .rgba = {}};
    for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
        for (int const value : {i % 14 < 7 ? 255 : 0, 188, 0, 255}) picture.rgba.push_back(static_cast<std::uint8_t>(value));
    scene.pictures.push_back(picture);
    scene.materials[0].base_color_texture.picture = 1; // 0 is the black texel
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0);
    glm::vec3 const found = albedo_from_above(scene);
    EXPECT_NEAR(found.x, 0.25f, 1e-3f);
    EXPECT_NEAR(found.y, 0.25f, 2e-3f); // 188 of 255 is half of the light
    EXPECT_EQ(found.z, 0);
}

TEST(SceneAlbedo, is_black_where_nothing_faces_up) { expect_color(albedo_from_above(Scene{}), glm::vec3(0)); }
