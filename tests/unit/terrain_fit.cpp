#include "render/terrain_fit.h"
#include "scene/planet.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

/// A scene of 4 by 2 km and 500 m at the pole, around its origin.
ShadowScene scene_at_pole(double radius) {
    ShadowScene scene{{{-2000, -100, -1000}, {2000, 400, 1000}}, glm::dmat4(1)};
    scene.world_from_scene[3] = {0, radius, 0, 1};
    return scene;
}

} // namespace

TEST(TerrainFit, holds_the_scene_and_agrees_with_what_shaders_know) {
    Planet const earth = make_earth();
    ShadowScene const scene = scene_at_pole(earth.radius);
    TerrainFit const fit = fit_terrain(scene, earth, 128);
    ASSERT_EQ(fit.size, 128);
    glm::dvec3 const camera = fit.origin + glm::dvec3(70, 30, -20);
    shader::TerrainMap const map = terrain_constants(fit, camera);
    EXPECT_NEAR(map.altitude, 0, 1);
    for (glm::dvec3 const& corner : {scene.bounds.lowest, scene.bounds.highest, glm::dvec3(2000, 0, -1000)}) {
        glm::vec4 const clip = terrain_clip(fit) * glm::vec4(corner, 1);
        EXPECT_LT(std::max(std::abs(clip.x), std::abs(clip.y)), 1.0f);
        EXPECT_GT(clip.z, 0.0f);
        EXPECT_LT(clip.z, 1.0f);
        glm::vec3 const apart = glm::vec3(fit.origin + corner - camera) - map.origin;
        glm::vec2 const uv = (glm::vec2(glm::dot(apart, map.x), glm::dot(apart, map.y)) - map.lowest) / (map.texel * 128);
        EXPECT_NEAR(uv.x, 0.5f + 0.5f * clip.x, 1e-5f);
        EXPECT_NEAR(uv.y, 0.5f - 0.5f * clip.y, 1e-5f); // rows go down
        EXPECT_NEAR(map.bottom + clip.z * map.range, corner.y, 1e-2);
    }
}

TEST(TerrainFit, is_seen_from_above_and_not_mirrored) {
    TerrainFit const fit = fit_terrain(scene_at_pole(make_earth().radius), make_earth(), 64);
    EXPECT_NEAR(glm::distance(glm::cross(fit.axes[0], fit.axes[1]), fit.axes[2]), 0, 1e-12);
    EXPECT_NEAR(fit.axes[2].y, 1, 1e-12);
    EXPECT_NEAR(glm::distance(middle(fit), fit.origin + glm::dvec3(0, 150, 0)), 0, 1e-6);
}

TEST(TerrainFit, there_is_no_map_for_nothing_and_for_half_a_planet) {
    Planet const earth = make_earth();
    EXPECT_EQ(fit_terrain({{}, glm::dmat4(1)}, earth, 128).size, 0);
    EXPECT_EQ(fit_terrain(scene_at_pole(earth.radius), earth, 0).size, 0);
    ShadowScene wide = scene_at_pole(earth.radius);
    wide.bounds.highest.x = earth.radius;
    EXPECT_EQ(fit_terrain(wide, earth, 128).size, 0);
}
