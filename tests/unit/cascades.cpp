#include "render/cascades.h"
#include "scene/view.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace alpenglow;

namespace {

constexpr double RADIUS = 6.36e6;
glm::dvec3 const TO_SUN = world_from_elevation_azimuth(0.5, 2.0, default_anchor.latitude, default_anchor.longitude);

/// The default terrain's size: 100 km square, 2 km high.
ShadowScene terrain() {
    Placement const placement{.anchor = default_anchor};
    return {{{-5e4, 0, -5e4}, {5e4, 2e3, 5e4}}, world_from_scene(placement, RADIUS)};
}

Camera camera_above(double altitude, double heading, double pitch) {
    CameraPlace place;
    place.place = {default_anchor.latitude, default_anchor.longitude, altitude};
    place.heading = heading, place.pitch = pitch;
    return camera_at(place, RADIUS);
}

ShadowFit fit(Camera const& camera) { return fit_cascades(terrain(), camera, TO_SUN, {}); }

double from_grid(double x, double texel) { return std::abs(x / texel - std::round(x / texel)); }

/// How many half widths from a cascade's centre a place lies; at most 1 inside.
double half_widths_away(ShadowFit const& shadow, CascadeFit const& cascade, glm::dvec3 const& world) {
    glm::dvec2 const offset = glm::abs(glm::dvec2(shadow.light_from_world * world) - cascade.centre);
    return std::max(offset.x, offset.y) / cascade.half_width;
}

/// A place of the scene's ground.
glm::dvec3 ground(double east, double north) { return glm::dvec3(terrain().world_from_scene * glm::dvec4(east, 0, -north, 1)); }

} // namespace

TEST(Cascades, each_is_inside_the_next) {
    for (double const altitude : {2.0, 500.0, 12e3, 4e5, 2e7}) {
        ShadowFit const shadow = fit(camera_above(altitude, 1.0, -0.3));
        ASSERT_FALSE(shadow.cascades.empty());
        for (std::size_t i = 0; i + 1 < shadow.cascades.size(); ++i) {
            CascadeFit const &fine = shadow.cascades[i], &coarse = shadow.cascades[i + 1];
            EXPECT_LT(fine.half_width, coarse.half_width);
            glm::dvec2 const offset = glm::abs(fine.centre - coarse.centre);
            // To a texel: each centre is rounded by itself.
            EXPECT_LE(std::max(offset.x, offset.y) + fine.half_width, coarse.half_width + coarse.texel) << "altitude " << altitude << ", cascade " << i;
        }
    }
}

TEST(Cascades, the_grid_of_texels_stays_where_it_is) {
    Camera const still = camera_above(300, 1.0, -0.1);
    ShadowFit const before = fit(still);
    for (int step = 1; step <= 12; ++step) {
        Camera moved = camera_above(300, 1.0 + 0.1 * step, -0.1 + 0.02 * step);
        moved.position = still.position + glm::dvec3(0.037, -0.021, 0.013) * (step * before.cascades.front().texel);
        ShadowFit const after = fit(moved);
        ASSERT_EQ(after.cascades.size(), before.cascades.size());
        for (std::size_t i = 0; i < after.cascades.size(); ++i) {
            EXPECT_EQ(after.cascades[i].texel, before.cascades[i].texel);
            glm::dvec2 const shift = after.cascades[i].centre - before.cascades[i].centre;
            // A double at 6e6 m has steps of 1e-9 m, far below a thousandth of the finest texel.
            EXPECT_LT(from_grid(shift.x, before.cascades[i].texel), 1e-3) << "step " << step << ", cascade " << i;
            EXPECT_LT(from_grid(shift.y, before.cascades[i].texel), 1e-3) << "step " << step << ", cascade " << i;
        }
    }
}

TEST(Cascades, sizes_do_not_depend_on_where_the_camera_looks) {
    double const finest = fit(camera_above(9e3, 0, 0)).cascades.front().half_width;
    for (double heading = 0; heading < 6.3; heading += 0.3) {
        for (double const pitch : {-1.5, -0.4, 0.0, 0.8}) EXPECT_EQ(fit(camera_above(9e3, heading, pitch)).cascades.front().half_width, finest);
    }
}

TEST(Cascades, hold_the_camera_and_what_is_right_in_front_of_it) {
    for (double heading = 0; heading < 6.3; heading += 0.5) {
        Camera const camera = camera_above(300, heading, -0.05);
        ShadowFit const shadow = fit(camera);
        for (CascadeFit const& cascade : shadow.cascades) {
            EXPECT_LT(half_widths_away(shadow, cascade, camera.position), 0.95);
            EXPECT_LT(half_widths_away(shadow, cascade, camera.position + 0.4 * cascade.half_width * camera.forward()), 0.95);
        }
    }
}

TEST(Cascades, from_12_km_and_from_orbit_they_cover_the_part_of_the_scene_in_view) {
    for (double const altitude : {12e3, 4e5}) {
        ShadowFit const shadow = fit(camera_above(altitude, 0, glm::radians(-89.0)));
        for (double const place : {-20e3, 0.0, 20e3}) {
            EXPECT_LT(half_widths_away(shadow, shadow.cascades.back(), ground(place, 0)), 1) << altitude;
            EXPECT_LT(half_widths_away(shadow, shadow.cascades.back(), ground(0, place)), 1) << altitude;
        }
    }
    // Shallow from 12 km: what lies 10 to 50 km ahead, inside the reach.
    ShadowFit const shadow = fit(camera_above(12e3, 0, glm::radians(-20.0)));
    for (double north = 10e3; north <= 50e3; north += 10e3) EXPECT_LT(half_widths_away(shadow, shadow.cascades.back(), ground(0, north)), 1);
}

TEST(Cascades, from_afar_no_texel_is_spent_below_a_pixel) {
    // From 400 km a pixel of a full-HD picture is 430 m wide.
    EXPECT_GT(fit(camera_above(4e5, 0, -1.5)).cascades.front().texel, 10);
    EXPECT_LT(fit(camera_above(10, 0, 0)).cascades.front().texel, 0.6);
}

TEST(Cascades, the_depth_range_holds_the_whole_scene) {
    ShadowFit const shadow = fit(camera_above(300, 0, 0));
    for (double const east : {-5e4, 5e4}) {
        for (double const north : {-5e4, 5e4}) {
            double const z = (shadow.light_from_world * ground(east, north)).z;
            EXPECT_GT(z, shadow.nearest);
            EXPECT_LT(z, shadow.farthest);
        }
    }
}

TEST(Cascades, casters_behind_the_camera_and_towards_the_sun_are_kept) {
    ShadowFit const shadow = fit(camera_above(300, 0, 0));
    CascadeFit const& fine = shadow.cascades.front();
    glm::dvec3 const middle = camera_above(300, 0, 0).position;
    for (double const towards_sun : {-1e3, 0.0, 1e3, 4e4}) EXPECT_TRUE(touches(fine, shadow.light_from_world, {middle + towards_sun * TO_SUN, 1}));
    glm::dvec3 const across = glm::transpose(shadow.light_from_world)[0];
    EXPECT_FALSE(touches(fine, shadow.light_from_world, {middle + 3 * fine.half_width * across, 1}));
    EXPECT_TRUE(touches(fine, shadow.light_from_world, {middle + 3 * fine.half_width * across, 3 * fine.half_width}));
}

TEST(Cascades, there_is_none_without_a_scene) {
    EXPECT_TRUE(fit_cascades({}, camera_above(300, 0, 0), TO_SUN, {}).cascades.empty());
}

TEST(Cascades, one_cascade_covers_what_four_do) {
    Camera const camera = camera_above(300, 0, 0);
    ShadowSettings one;
    one.cascades = 1;
    ShadowFit const single = fit_cascades(terrain(), camera, TO_SUN, one);
    ASSERT_EQ(single.cascades.size(), 1u);
    EXPECT_EQ(single.cascades.front().half_width, fit(camera).cascades.back().half_width);
}

TEST(InView, keeps_what_may_be_seen_and_drops_the_rest) {
    Camera const camera = camera_above(300, 0, 0);
    auto const at = [&](double right, double up, double ahead) { return camera.position + camera.world_from_camera * glm::dvec3(right, up, -ahead); };
    EXPECT_TRUE(in_view(camera, 1.78, {at(0, 0, 100), 1}));
    EXPECT_FALSE(in_view(camera, 1.78, {at(0, 0, -100), 1}));
    EXPECT_TRUE(in_view(camera, 1.78, {at(0, 0, -100), 101}));
    EXPECT_FALSE(in_view(camera, 1.78, {at(300, 0, 100), 1}));
    EXPECT_TRUE(in_view(camera, 1.78, {at(102, 0, 100), 1})); // tan 30° x 1.78 = 1.03
    EXPECT_FALSE(in_view(camera, 1.0, {at(102, 0, 100), 1}));
}
