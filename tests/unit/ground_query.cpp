#include "scene/ground_query.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

constexpr double RADIUS = 6'360'000;

/// A square of `side` metres in the scene's plane, its corners at the heights given (glTF axes: -z is north).
Scene square(double side, std::array<float, 4> const& heights) {
    auto const half = static_cast<float>(side / 2);
    Scene scene;
    Mesh mesh;
    glm::vec3 const corners[] = {{-half, heights[0], half}, {half, heights[1], half}, {half, heights[2], -half}, {-half, heights[3], -half}};
    for (glm::vec3 const& corner : corners) mesh.vertices.push_back({.position = corner});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    return scene;
}

Placement at(double latitude, double longitude, double altitude = 0) { return {.anchor = {latitude, longitude, altitude}}; }

} // namespace

TEST(GroundQuery, finds_the_plane_over_a_place_on_the_globe) {
    for (Placement const& placement : {at(0, 0), at(0.8, 3.14), at(M_PI / 2, 1), at(-0.7, -3.1, 300)}) {
        GroundQuery const ground(square(1000, {100, 100, 100, 100}), placement, RADIUS);
        glm::dmat4 const world = world_from_scene(placement, RADIUS);
        // A flat plane rises over the sphere by d^2 / 2R: 12.8 mm at 404 m.
        for (glm::dvec2 const& place : {glm::dvec2(0, 0), glm::dvec2(350, 200), glm::dvec2(-499, 3)}) {
            glm::dvec3 const on_plane(world * glm::dvec4(place.x, 100, place.y, 1));
            auto const altitude = ground.altitude(on_plane * 1.001); // any height over the same place
            ASSERT_TRUE(altitude);
            EXPECT_NEAR(*altitude, glm::length(on_plane) - RADIUS, 1e-6);
        }
        EXPECT_FALSE(ground.altitude(glm::dvec3(world * glm::dvec4(501, 0, 0, 1))));
        EXPECT_FALSE(ground.altitude(-glm::dvec3(world[3]))); // the other side of the planet
    }
}

TEST(GroundQuery, follows_slopes_and_takes_the_highest) {
    Scene scene = square(1000, {0, 100, 100, 0}); // rises to the east
    Placement const placement = at(0.8, 0.13);
    glm::dmat4 const world = world_from_scene(placement, RADIUS);
    glm::dvec3 const over(world * glm::dvec4(250, 500, 0, 1));
    EXPECT_NEAR(GroundQuery(scene, placement, RADIUS).altitude(over).value(), 75, 0.03); // 250 m away the vertical leans 2 cm
    scene.instances.push_back({.mesh = 0, .scene_from_mesh = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 40, 0, 1)});
    EXPECT_NEAR(GroundQuery(scene, placement, RADIUS).altitude(over).value(), 115, 0.03);
}

TEST(GroundQuery, small_triangles_far_from_the_centre_keep_their_precision) {
    // 3 m triangles 6360 km from the planet's centre, in a strip: their shared edges leave no gap.
    Scene scene;
    Mesh mesh;
    for (int i = 0; i <= 300; ++i) {
        for (int side = 0; side < 2; ++side) mesh.vertices.push_back({.position = {3.0f * float(i), 10.0f * float(i % 2), 3.0f * float(side)}});
    }
    for (std::uint32_t i = 0; i < 300; ++i) {
        for (std::uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) mesh.indices.push_back(2 * i + corner);
    }
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    Placement const placement = at(0.8, 0.13);
    GroundQuery const ground(scene, placement, RADIUS);
    glm::dmat4 const world = world_from_scene(placement, RADIUS);
    for (int i = 1; i < 300; ++i) {
        glm::dvec3 const vertex(world * glm::dvec4(3.0 * i, 10.0 * (i % 2), 1.5, 1));
        auto const altitude = ground.altitude(vertex);
        ASSERT_TRUE(altitude) << i;
        EXPECT_NEAR(*altitude, glm::length(vertex) - RADIUS, 1e-4) << i; // a vertical is off by 1e-9 m sideways on a 10:3 slope
    }
}

TEST(GroundQuery, an_empty_scene_has_no_ground) {
    EXPECT_FALSE(GroundQuery({}, {}, RADIUS).altitude({RADIUS, 0, 0}));
}
