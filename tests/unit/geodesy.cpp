#include "scene/camera.h"
#include "scene/geodesy.h"
#include "scene/scene.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace alpenglow;

namespace {

constexpr double RADIUS = 6'360'000;
constexpr double PI = std::numbers::pi;
// Where things go wrong: poles, date line, equator, Greenwich, and a place of no distinction.
constexpr Geodetic PLACES[] = {{PI / 2, 0.7, 2}, {-PI / 2, -2, 800}, {0.3, PI, 5}, {0.3, -PI + 1e-9, 5}, {0, 0, 0}, {0.8, 0.13, 2e7}, {1e-12, 1e-12, 1e9}};
constexpr double ROUNDING = 1e-14; // a few operations on numbers of size 1, in doubles

void expect_rotation(glm::dmat3 const& m) {
    glm::dmat3 const square = glm::transpose(m) * m;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(square[i][j], i == j, ROUNDING);
    }
    EXPECT_NEAR(glm::determinant(m), 1, ROUNDING);
}

void expect_near(glm::dvec3 const& a, glm::dvec3 const& b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

} // namespace

TEST(Geodesy, places_survive_the_way_through_the_world) {
    for (Geodetic const& place : PLACES) {
        glm::dvec3 const world = world_from_geodetic(place, RADIUS);
        Geodetic const back = geodetic_from_world(world, RADIUS);
        double const rounding = 4e-16 * (RADIUS + place.altitude); // [m] two last places of the distance from the centre
        EXPECT_NEAR(back.altitude, place.altitude, rounding);
        expect_near(world_from_geodetic(back, RADIUS), world, 2 * rounding);
    }
}

TEST(Geodesy, axes_are_where_the_convention_says) {
    expect_near(world_from_geodetic({0, 0, 0}, RADIUS), {RADIUS, 0, 0}, 0);
    expect_near(world_from_geodetic({0, PI / 2, 0}, RADIUS), {0, RADIUS, 0}, 1e-9);
    expect_near(world_from_geodetic({PI / 2, 0, 10}, RADIUS), {0, 0, RADIUS + 10}, 1e-9);
    glm::dmat3 const frame = world_from_east_north_up(0, 0);
    expect_near(frame[0], {0, 1, 0}, 0);
    expect_near(frame[1], {0, 0, 1}, 0);
    expect_near(frame[2], {1, 0, 0}, 0);
}

TEST(Geodesy, frames_are_rotations_everywhere) {
    for (Geodetic const& place : PLACES) {
        expect_rotation(world_from_east_north_up(place.latitude, place.longitude));
        expect_rotation(world_from_gltf_axes(place.latitude, place.longitude, 0.4));
    }
}

TEST(Geodesy, azimuth_is_clockwise_from_north) {
    glm::dmat3 const frame = world_from_east_north_up(0.8, 0.13);
    expect_near(world_from_elevation_azimuth(0, 0, 0.8, 0.13), frame[1], ROUNDING);
    expect_near(world_from_elevation_azimuth(0, PI / 2, 0.8, 0.13), frame[0], ROUNDING);
    expect_near(world_from_elevation_azimuth(PI / 2, 1, 0.8, 0.13), frame[2], ROUNDING);
}

TEST(Geodesy, gltf_axes_stand_on_the_ground_and_turn_clockwise) {
    glm::dmat3 const frame = world_from_east_north_up(0.8, 0.13);
    glm::dmat3 const axes = world_from_gltf_axes(0.8, 0.13, 0);
    expect_near(axes[0], frame[0], ROUNDING);
    expect_near(axes[1], frame[2], ROUNDING);
    expect_near(-axes[2], frame[1], ROUNDING);
    expect_near(-world_from_gltf_axes(0.8, 0.13, PI / 2)[2], frame[0], ROUNDING); // what looked north looks east
}

TEST(Geodesy, a_placed_scene_is_scaled_turned_and_moved) {
    Placement const placement{.anchor = {0.8, 0.13, 100}, .yaw = PI / 2, .scale = 3, .curve = false};
    glm::dmat4 const world_from = world_from_scene(placement, RADIUS);
    glm::dmat3 const frame = world_from_east_north_up(0.8, 0.13);
    glm::dvec3 const anchor = world_from_geodetic(placement.anchor, RADIUS);
    expect_near(world_from * glm::dvec4(0, 0, 0, 1), anchor, 0);
    expect_near(glm::dvec3(world_from * glm::dvec4(0, 2, -5, 1)), anchor + 6.0 * frame[2] + 15.0 * frame[0], 1e-8);
}

TEST(CameraAngles, headings_and_pitches_look_where_they_say) {
    for (Geodetic const& p : PLACES) {
        glm::dmat3 const frame = world_from_east_north_up(p.latitude, p.longitude);
        Camera camera;
        camera.world_from_camera = world_from_camera_angles(p.latitude, p.longitude, 0, 0, 0);
        expect_near(camera.forward(), frame[1], ROUNDING);
        expect_near(camera.world_from_camera[0], frame[0], ROUNDING);
        camera.world_from_camera = world_from_camera_angles(p.latitude, p.longitude, PI / 2, 0, 0);
        expect_near(camera.forward(), frame[0], ROUNDING);
        camera.world_from_camera = world_from_camera_angles(p.latitude, p.longitude, 1, -PI / 2, 0);
        expect_near(camera.forward(), -frame[2], ROUNDING);
        // A pilot who rolls clockwise has the right wing down.
        glm::dmat3 const rolled = world_from_camera_angles(p.latitude, p.longitude, 0, 0, 0.1);
        EXPECT_NEAR(glm::dot(rolled[0], frame[2]), -std::sin(0.1), ROUNDING);
        expect_rotation(rolled);
    }
}

TEST(CameraAngles, are_found_again_straight_down_too) {
    for (Geodetic const& p : PLACES) {
        for (double const pitch : {-PI / 2, -PI / 2 + 1e-7, -1.2, 0.0, 0.4, PI / 2}) {
            for (double const heading : {-3.1, 0.0, 2.0}) {
                for (double const roll : {-2.5, 0.0, 0.3}) {
                    glm::dmat3 const m = world_from_camera_angles(p.latitude, p.longitude, heading, pitch, roll);
                    CameraAngles const a = camera_angles(m, p.latitude, p.longitude);
                    glm::dmat3 const back = world_from_camera_angles(p.latitude, p.longitude, a.heading, a.pitch, a.roll);
                    // Within 1e-9 of the vertical the pitch is taken as it is, the rest as straight.
                    for (int i = 0; i < 3; ++i) expect_near(back[i], m[i], 2e-9);
                }
            }
        }
    }
    CameraAngles const plain = camera_angles(world_from_camera_angles(0.5, 2, 1, -0.3, 0.2), 0.5, 2);
    EXPECT_NEAR(plain.heading, 1, ROUNDING);
    EXPECT_NEAR(plain.pitch, -0.3, ROUNDING);
    EXPECT_NEAR(plain.roll, 0.2, ROUNDING);
}
