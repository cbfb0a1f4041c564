#include "scene/fly_camera.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace alpenglow;

namespace {

constexpr double PI = std::numbers::pi;
constexpr double RADIUS = 6'360'000;

CameraPlace at(double latitude, double longitude, double altitude, double heading = 0, double pitch = 0) {
    return {.place = {latitude, longitude, altitude}, .heading = heading, .pitch = pitch, .roll = 0, .vertical_fov = 1};
}

FlyInput forward() { return {.move = {0, 0, 1}}; }

} // namespace

TEST(FlyCamera, starts_as_the_view_says_and_gives_the_view_back) {
    CameraPlace place = at(0.8, 0.13, 900, -2, 0.4);
    place.roll = 0.3;
    FlyCamera const fly(place, RADIUS);
    Camera const expected = camera_at(place, RADIUS);
    EXPECT_LT(glm::length(fly.camera().position - expected.position), 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(fly.camera().world_from_camera[i] - expected.world_from_camera[i]), 1e-14);
    CameraPlace const back = fly.place();
    EXPECT_NEAR(back.place.latitude, 0.8, 1e-15);
    EXPECT_NEAR(back.place.altitude, 900, 2e-9);
    EXPECT_NEAR(back.heading, -2, 1e-14);
    EXPECT_EQ(back.pitch, 0.4);
    EXPECT_EQ(back.roll, 0.3);
    EXPECT_EQ(back.vertical_fov, 1);
}

TEST(FlyCamera, speed_follows_the_height_over_the_ground) {
    EXPECT_DOUBLE_EQ(FlyCamera(at(0, 0, 2), RADIUS).speed(), 2);
    EXPECT_NEAR(FlyCamera(at(0, 0, 1000), RADIUS).speed(), 500, 1e-8);
    EXPECT_NEAR(FlyCamera(at(0, 0, 1000), RADIUS).speed(900), 50, 1e-8);
    FlyCamera fly(at(0, 0, 1000), RADIUS);
    glm::dvec3 const start = fly.camera().position;
    fly.advance(0.1, {.move = {0, 0, 1}, .boost = 3});
    EXPECT_NEAR(glm::length(fly.camera().position - start), 150, 1e-6);
}

TEST(FlyCamera, keys_move_along_the_cameras_axes) {
    CameraPlace const place = at(0.8, 0.13, 5000, 1, -0.5);
    glm::dmat3 const axes = camera_at(place, RADIUS).world_from_camera;
    for (int axis = 0; axis < 3; ++axis) {
        FlyCamera fly(place, RADIUS);
        FlyInput input;
        input.move[axis] = 1;
        glm::dvec3 const start = fly.camera().position;
        fly.advance(0.01, input);
        glm::dvec3 const way = glm::normalize(fly.camera().position - start);
        EXPECT_LT(glm::length(way - (axis == 2 ? -axes[2] : axes[axis])), 1e-7) << axis;
    }
}

TEST(FlyCamera, the_mouse_turns_about_the_local_vertical) {
    FlyCamera fly(at(0.8, 0.13, 5000, 1, -0.5), RADIUS);
    fly.advance(0, {.yaw = 0.2, .pitch = 0.1});
    EXPECT_NEAR(fly.place().heading, 1.2, 1e-14);
    EXPECT_NEAR(fly.place().pitch, -0.4, 1e-14);
    EXPECT_EQ(fly.place().roll, 0);
    fly.advance(0, {.pitch = 9}); // it stops at the zenith, and turns there
    EXPECT_NEAR(fly.place().pitch, PI / 2, 1e-15);
    fly.advance(0, {.yaw = 0.2, .pitch = -PI / 2});
    EXPECT_NEAR(fly.place().heading, 1.4, 1e-14);
    EXPECT_NEAR(fly.place().pitch, 0, 1e-14);
    fly.advance(0, {.roll = 2 * PI + 0.1});
    EXPECT_NEAR(fly.place().roll, 0.1, 1e-14);
}

TEST(FlyCamera, flies_once_round_the_planet_over_the_pole_without_turning) {
    CameraPlace const start = at(0.8, 0.13, 1e6, 0, 0); // due north
    FlyCamera fly(start, RADIUS);
    double highest_latitude = 0;
    for (int i = 0; i < 20000; ++i) {
        // Level flight on a sphere: keep the altitude by looking a little down, as gravity would.
        glm::dvec3 const up_before = glm::normalize(fly.camera().position);
        fly.advance(0.01, forward());
        glm::dvec3 const up = glm::normalize(fly.camera().position);
        highest_latitude = std::max(highest_latitude, fly.place().place.latitude);
        EXPECT_NEAR(glm::dot(fly.camera().forward(), up), 0, 1e-12);      // pitch stays
        EXPECT_NEAR(glm::dot(fly.camera().world_from_camera[0], up), 0, 1e-12); // so does roll
        ASSERT_LT(glm::length(up - up_before), 0.01);
    }
    EXPECT_GT(highest_latitude, PI / 2 - 0.01);
    // The great circle of the start: its axis is the camera's right hand all the way.
    glm::dvec3 const right = camera_at(start, RADIUS).world_from_camera[0];
    EXPECT_GT(glm::dot(fly.camera().world_from_camera[0], right), 1 - 1e-9);
}

TEST(FlyCamera, stays_over_the_ground_and_within_reach_of_a_view_file) {
    FlyCamera low(at(0.8, 0.13, 640, 0, -1), RADIUS);
    for (int i = 0; i < 200; ++i) low.advance(0.1, forward(), 600);
    EXPECT_NEAR(low.altitude(), 601, 1e-6);
    FlyCamera sea(at(0.8, 0.13, 50, 0, -PI / 2), RADIUS);
    for (int i = 0; i < 200; ++i) sea.advance(0.1, forward());
    EXPECT_NEAR(sea.altitude(), 1, 1e-6);
    FlyCamera high(at(0.8, 0.13, 1e8, 0, PI / 2), RADIUS);
    for (int i = 0; i < 200; ++i) high.advance(1, forward());
    EXPECT_LE(high.altitude(), 1e9);
    EXPECT_GT(high.altitude(), 9.9e8);
}
