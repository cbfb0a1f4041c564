#include "support/air.h"
#include "support/air_reference.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {
constexpr float R = 6.36e6f;

// The largest error of altitude [m] inside the air, along rays that graze altitudes from 0 to 90 km, for a camera at
// h0.
double worst_altitude(float h0) {
    Atmosphere const air = test::earth_air();
    double worst = 0;
    for (double graze = 0; graze <= 9e4; graze += 1500) {
        double const sine = (R + std::min<double>(graze, h0)) / (R + double(h0));
        float const mu = -float(std::sqrt(std::max(0.0, 1 - sine * sine)));
        test::reference::Ray const exact{R, h0, mu};
        float entry = 0;
        AirRay const ray = enter_air(air, make_air_ray(R, h0, mu, 0, 0), entry);
        double const exact_entry = h0 > air.top_altitude ? exact.crossings(air.top_altitude)[0] : 0;
        float const out = distance_out_of(ray, air.top_altitude);
        for (int i = 0; i <= 200; ++i) {
            float const t = out * float(i) / 200;
            worst = std::max(worst, std::abs(double(altitude_at(ray, t)) - exact.altitude(exact_entry + t)));
        }
    }
    return worst;
}
} // namespace

TEST(Geometry, altitude_in_float_keeps_centimetres_along_grazing_rays) {
    for (float const h0 : {0.0f, 2.0f, 100.0f, 3000.0f, 12000.0f, 50000.0f, 100000.0f})
        EXPECT_LT(worst_altitude(h0), 0.05) << h0;
    // From above the air squares of 1e13 m² cancel; rounded to 1e6 they would be a metre off. Odd altitudes round too.
    for (float const h0 : {100.1e3f, 137.317e3f, 200e3f, 400e3f, 733.3333e3f, 1000e3f, 3141.5926e3f, 20000e3f})
        EXPECT_LT(worst_altitude(h0), 0.1) << h0;
}

TEST(Geometry, places_on_the_ground_are_told_from_anywhere) {
    Atmosphere const air = test::earth_air();
    for (float const h0 : {2.0f, 3e4f, 400e3f, 20000e3f})
        for (float const below : {0.001f, 0.1f, 0.5f}) { // of the way from the horizon to straight down
            float const mu = -1 + (1 + horizon_mu(R, h0)) * (1 - below);
            test::reference::Ray const exact{R, h0, mu, 0.3, -0.2};
            double const t = exact.crossings(0)[0];
            AirPoint const place = place_at(air, make_air_ray(R, h0, mu, 0.3f, -0.2f), float(t));
            // Distances of 2e7 m in float, to the place and to the air, are off by 1 m each, on a slope of at most 1.
            EXPECT_NEAR(place.altitude, 0, h0 > 1e6f ? 2.1 : 0.15) << h0 << ' ' << mu;
            EXPECT_NEAR(place.mu, exact.mu(t), 1e-5) << h0 << ' ' << mu;
            EXPECT_NEAR(place.mu_s, exact.mu_s(t), 1e-6) << h0 << ' ' << mu;
        }
    AirRay const past = make_air_ray(R, 400e3f, 0.1f, 0, 0); // never meets the air
    EXPECT_EQ(place_at(air, past, 5e4f).altitude, altitude_at(past, 5e4f));
}

TEST(Geometry, two_floats_hold_a_sum_and_a_product) {
    for (float const a : {6.36e6f, 7.3611115e6f, 1e8f / 3})
        for (float const b : {-0.7123456f, 1.2345678e3f, -2.3456789e6f}) {
            TwoFloat const sum = two_sum(a, b), product = two_product(a, b);
            EXPECT_EQ(double(sum.high) + double(sum.low), double(a) + double(b));
            EXPECT_EQ(double(product.high) + double(product.low), double(a) * double(b));
        }
}

TEST(Geometry, altitude_near_the_camera_is_exact) {
    for (float const mu : {-1.0f, -0.5f, -0.01f, 0.0f, 0.3f, 1.0f})
        for (float const t : {0.001f, 0.1f, 1.0f, 30.0f}) {
            test::reference::Ray const exact{R, 40, mu};
            EXPECT_NEAR(altitude_at(make_air_ray(R, 40, mu, 0, 0), t), exact.altitude(t), 1e-5) << mu << " " << t;
        }
}

TEST(Geometry, the_cosines_follow_the_ray) {
    test::reference::Ray const exact{R, 2000, -0.02, 0.1, 0.6};
    AirRay const ray = make_air_ray(R, 2000, -0.02f, 0.1f, 0.6f);
    for (float const t : {0.0f, 1e3f, 1e5f, 5e5f}) {
        AirPoint const point = air_point_at(ray, t);
        EXPECT_NEAR(point.mu, exact.mu(t), 2e-7);
        EXPECT_NEAR(point.mu_s, exact.mu_s(t), 2e-7);
    }
}

// Boody's 2.4.4 prints another formula; these are the values of the right one.
TEST(Geometry, the_horizon_sinks_with_altitude) {
    auto const angle = [](float h) { return glm::degrees(std::acos(double(horizon_mu(R, h)))); };
    EXPECT_NEAR(angle(0), 90, 1e-5);
    EXPECT_NEAR(angle(1000), 91.016, 0.001);
    EXPECT_NEAR(angle(100'000), 100.09, 0.005);
}

TEST(Geometry, rays_meet_the_ground_and_the_top_where_they_should) {
    Atmosphere const air = test::earth_air();
    for (float const h0 : {0.0f, 2.0f, 5000.0f, 99000.0f})
        for (float const mu : {-1.0f, -0.3f, -0.1f, 0.0f, 0.05f, 1.0f}) {
            test::reference::Ray const exact{R, h0, mu};
            AirSegment const segment = air_segment(air, make_air_ray(R, h0, mu, 0, 0));
            bool const hits = mu < 0 && exact.crossings(0)[0] >= -1e-3;
            EXPECT_EQ(segment.hits_ground, hits) << h0 << " " << mu;
            double const end = hits ? std::max(0.0, exact.crossings(0)[0]) : exact.crossings(air.top_altitude)[1];
            EXPECT_NEAR(segment.end, end, 1e-6 * end + 1e-3) << h0 << " " << mu;
        }
}

TEST(Geometry, a_camera_in_space_enters_the_air_or_misses_it) {
    Atmosphere const air = test::earth_air();
    float entry = 0;
    AirRay const down = enter_air(air, make_air_ray(R, 2e7f, -1, 0.5f, -0.5f), entry);
    EXPECT_FLOAT_EQ(entry, 2e7f - 1e5f);
    EXPECT_FLOAT_EQ(air_segment(air, down).end, 1e5f);
    EXPECT_TRUE(air_segment(air, down).hits_ground);
    EXPECT_NEAR(air_point_at(down, 0).mu_s, 0.5f, 1e-6f); // 0.5 m of 6 460 km
    for (float const mu : {1.0f, 0.3f, 0.0f, -0.3f, -0.9f}) {
        AirRay const away = enter_air(air, make_air_ray(R, 2e7f, mu, 0, 0), entry);
        EXPECT_EQ(air_segment(air, away).end, 0) << mu;
        EXPECT_TRUE(std::isfinite(entry));
    }
}
