#include "render/ground_light.h"
#include "support/scenes.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

Planet const EARTH = make_earth();

/// Over the pole.
glm::dvec3 place_at(double altitude, double east = 0) {
    return glm::normalize(glm::dvec3(east, EARTH.radius, 0)) * (EARTH.radius + altitude);
}

/// White level ground at the pole, `height` [m] above the planet.
std::vector<GroundPatch> white_square(double half_width, double height) {
    Scene scene = scene_of({matte(glm::vec3(1))});
    add_plane(scene, half_width);
    glm::dmat4 world_from_scene(1);
    world_from_scene[3].y = EARTH.radius + height;
    return ground_patches(scene, world_from_scene, EARTH.radius);
}

} // namespace

TEST(GroundAround, is_the_planets_where_there_is_no_scene) {
    EXPECT_EQ(ground_around(EARTH, place_at(100), {}), planet_ground(EARTH));
    EXPECT_EQ(ground_around(EARTH, place_at(100), {}).albedo, glm::vec3(EARTH.ground_albedo));
}

TEST(GroundAround, of_a_scene_that_fills_the_view_is_the_scenes) {
    GroundAround const ground = ground_around(EARTH, place_at(2000), white_square(150e3, 1500));
    EXPECT_GT(ground.albedo.x, 0.9f);
    EXPECT_GT(ground.altitude, 1350);
    EXPECT_LT(ground.altitude, 4000); // a level square stands off the sphere at its rim
}

// Each place counts by its solid angle: no step anywhere, and a scene that is far below or away counts for nothing.
TEST(GroundAround, gives_way_to_the_planets_with_height_and_distance) {
    std::vector<GroundPatch> const patches = white_square(30e3, 500);
    float const planet = float(EARTH.ground_albedo.x);
    float last = 1;
    for (double const altitude : {1e3, 5e3, 2e4, 1e5, 4e5, 4e6}) {
        float const albedo = ground_around(EARTH, place_at(altitude), patches).albedo.x;
        EXPECT_LT(albedo, last);
        EXPECT_GT(albedo, planet);
        last = albedo;
    }
    EXPECT_NEAR(last, planet, 2e-3);
    last = 1;
    for (double const east : {0.0, 2e4, 3e4, 4e4, 8e4, 3e5}) {
        float const albedo = ground_around(EARTH, place_at(1000, east), patches).albedo.x;
        EXPECT_LT(albedo, last);
        last = albedo;
    }
    EXPECT_NEAR(last, planet, 2e-3);
}

TEST(GroundAround, of_a_thing_on_the_ground_is_the_planets) {
    EXPECT_NEAR(ground_around(EARTH, place_at(2), white_square(10, 1)).albedo.x, EARTH.ground_albedo.x, 1e-4);
}
