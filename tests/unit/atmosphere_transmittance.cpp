#include "support/air.h"
#include "support/air_reference.h"

#include <gtest/gtest.h>

#include <random>

using namespace alpenglow;
using namespace alpenglow::shader;
namespace reference = alpenglow::test::reference;

namespace {
Atmosphere const AIR = test::earth_air();

// Relative errors of the transmittance from the table, over altitudes and directions above the horizon, dense at it.
std::vector<double> table_errors(Atmosphere const& atmosphere, test::Table const& table) {
    reference::Air const exact(atmosphere);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> errors;
    for (int i = 0; i < 6000; ++i) {
        double const x = unit(random), y = unit(random);
        float const h = float(atmosphere.top_altitude * (i % 2 ? x * x : x));
        double const horizon = -std::sqrt(1 - std::pow(exact.radius() / (exact.radius() + h), 2)) + 1e-6;
        float const mu = float(horizon + (1 - horizon) * (i % 3 ? y * y * y : y));
        dvec3 const depth = reference::optical_depth_to_top(exact, h, mu);
        vec3 const sampled = sample_optical_depth(table.sampler(), atmosphere, h, mu);
        for (int c = 0; c < 3; ++c)
            if (std::exp(-depth[c]) > 1e-4) errors.push_back(std::abs(std::expm1(depth[c] - double(sampled[c]))));
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}
} // namespace

// 300 Dobson units; Dereyne's profile holds 454.
TEST(Transmittance, the_ozone_column_is_300_dobson_units) {
    Planet planet = make_earth();
    planet.air.components = {planet.air.at("ozone")};
    vec3 const depth = compute_optical_depth_to_top(atmosphere_of(planet), 0, 1);
    EXPECT_NEAR(depth.x, 0.00975, 2e-5);
    EXPECT_NEAR(depth.y, 0.02822, 2e-5);
    EXPECT_NEAR(depth.z, 0.00128, 1e-5);
}

// Up, along and down through them, each alone.
TEST(Transmittance, every_profile_has_the_depth_of_quadrature) {
    Planet const motley = test::motley_planet();
    for (alpenglow::AirComponent const& component : motley.air.components) {
        Planet alone = motley;
        alone.air.components = {component};
        Atmosphere const air = atmosphere_of(alone);
        reference::Air const exact(air);
        for (float const h : {0.0f, 400.0f, 1501.0f, 12000.0f, 19000.0f, 21500.0f, 50000.0f})
            for (float const mu : {-0.06f, -0.01f, 0.0f, 0.002f, 0.05f, 0.3f, 1.0f}) {
                if (mu < horizon_mu(air.ground_radius, h)) continue;
                double const depth = reference::optical_depth_to_top(exact, h, mu).y;
                // 0.3 m of a path are what float leaves of its ends.
                EXPECT_NEAR(compute_optical_depth_to_top(air, h, mu).y, depth, 1e-3 * depth + 0.3 * component.extinction().y)
                    << component.name << " " << h << " " << mu;
            }
    }
}

TEST(Transmittance, the_mapping_goes_there_and_back) {
    for (int y = 0; y < TRANSMITTANCE_HEIGHT; y += 1)
        for (int x = 0; x < TRANSMITTANCE_WIDTH; x += 7) {
            vec2 const uv((float(x) + 0.5f) / TRANSMITTANCE_WIDTH, (float(y) + 0.5f) / TRANSMITTANCE_HEIGHT);
            vec2 const node = transmittance_altitude_mu_from_uv(AIR, uv);
            vec2 const back = transmittance_uv_from_altitude_mu(AIR, node.x, node.y);
            // In texels. The cosine of a far horizon rounds to 6e-8, which moves the distance to the top by metres.
            EXPECT_NEAR(back.x * TRANSMITTANCE_WIDTH, float(x) + 0.5f, 0.02f) << x << " " << y;
            EXPECT_NEAR(back.y * TRANSMITTANCE_HEIGHT, float(y) + 0.5f, 0.001f) << x << " " << y;
        }
}

TEST(Transmittance, the_axes_end_at_texel_centres) {
    vec2 const low =
        transmittance_altitude_mu_from_uv(AIR, vec2(0.5f / TRANSMITTANCE_WIDTH, 0.5f / TRANSMITTANCE_HEIGHT));
    EXPECT_EQ(low.x, 0);
    EXPECT_FLOAT_EQ(low.y, 1);
    vec2 const high =
        transmittance_altitude_mu_from_uv(AIR, vec2(1 - 0.5f / TRANSMITTANCE_WIDTH, 1 - 0.5f / TRANSMITTANCE_HEIGHT));
    EXPECT_FLOAT_EQ(high.x, 1e5f);
    EXPECT_NEAR(high.y, horizon_mu(AIR.ground_radius, 1e5f), 1e-6);
}

TEST(Transmittance, the_table_meets_the_integral_over_the_whole_domain) {
    auto const errors = table_errors(AIR, test::earth_transmittance());
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.005);
    EXPECT_LT(errors.back(), 0.02);
    Atmosphere const hazy = test::hazy_air();
    auto const hazy_errors = table_errors(hazy, test::make_transmittance_table(hazy));
    EXPECT_LT(hazy_errors[hazy_errors.size() * 99 / 100], 0.006);
    EXPECT_LT(hazy_errors.back(), 0.02);
}

TEST(Transmittance, the_sun_sets_behind_the_planet_disc_by_disc) {
    for (float const h : {0.0f, 3000.0f, 80000.0f}) {
        double const horizon = std::acos(double(horizon_mu(AIR.ground_radius, h)));
        for (double x = -1.5; x <= 1.5; x += 0.05) {
            float const mu_s = float(std::cos(horizon - x * double(AIR.sun_angular_radius)));
            // 0.006 is the polynomial's own error; the rest is the difference between an angle and its cosine.
            EXPECT_NEAR(sun_above_horizon(AIR, h, mu_s), reference::disc_share(x), 0.008) << h << " " << x;
        }
        EXPECT_EQ(sun_above_horizon(AIR, h, 1), 1);
        EXPECT_EQ(sun_above_horizon(AIR, h, -1), 0);
    }
}

// Relative errors of the sun's light from the table from before half of the disc has risen on; the share that has risen is another test's.
double sunlight_error(Atmosphere const& atmosphere) {
    reference::Air const exact(atmosphere);
    test::Table const table = test::make_sunlight_table(atmosphere);
    double worst = 0;
    for (float const h : {0.0f, 300.0f, 3000.0f, 15000.0f, 60000.0f}) {
        double const horizon = std::acos(double(horizon_mu(atmosphere.ground_radius, h)));
        for (double const radii : {-0.8, -0.4, 0.0, 0.5, 1.0, 1.7, 3.0, 6.0, 12.0, 19.0, 50.0, 200.0}) {
            float const mu_s = float(std::cos(horizon - radii * double(atmosphere.sun_angular_radius)));
            dvec3 const truth = reference::sun_transmittance(exact, h, mu_s) / reference::disc_share(radii);
            vec3 const found = sample_sun_transmittance(table.sampler(), atmosphere, h, mu_s) / sun_above_horizon(atmosphere, h, mu_s);
            for (int c = 0; c < 3; ++c)
                if (truth[c] > 1e-6) worst = std::max(worst, std::abs(double(found[c]) / truth[c] - 1));
        }
    }
    return worst;
}

TEST(Transmittance, sunlight_is_the_mean_over_the_disc) {
    EXPECT_LT(sunlight_error(AIR), 0.01);
    EXPECT_LT(sunlight_error(test::hazy_air()), 0.01);
}

// Dereyne's code block 10 starts the sun's path at the camera: the zenith at sunset is then 3 to 56 times too dark.
TEST(Transmittance, a_samples_sunlight_starts_at_the_sample) {
    AirRay const zenith = make_air_ray(AIR.ground_radius, 0, 1, 0.01f, 0.01f);
    AirPoint const sample = air_point_at(zenith, 15000);
    vec3 const sun = sample_sun_transmittance(test::earth_sunlight().sampler(), AIR, sample.altitude, sample.mu_s);
    dvec3 const exact = reference::sun_transmittance(reference::Air(AIR), 15000, sample.mu_s);
    vec3 const camera = sample_sun_transmittance(test::earth_sunlight().sampler(), AIR, 0, 0.01f);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sun[c], exact[c], 0.005 * exact[c]);
        EXPECT_GT(sun[c], 2 * camera[c]);
    }
}

// Between points up, down, level and across the lowest point: trusted segments agree with the integral within 0.5 %.
TEST(Transmittance, trusted_segments_agree_with_the_integral) {
    reference::Air const exact(AIR);
    int trusted = 0, all = 0;
    for (float const h0 : {2.0f, 500.0f, 3000.0f, 12000.0f, 60000.0f})
        for (float const mu : {-1.0f, -0.5f, -0.1f, -0.03f, -0.003f, 0.0f, 0.02f, 0.1f, 0.4f, 1.0f})
            for (float const share : {0.01f, 0.1f, 0.5f, 1.0f}) {
                AirRay const ray = make_air_ray(AIR.ground_radius, h0, mu, 0, 0);
                float const end = air_segment(AIR, ray).end * share;
                auto const segment = sample_segment_transmittance(test::earth_transmittance().sampler(), AIR,
                                                                  air_point_at(ray, 0), air_point_at(ray, end));
                dvec3 const depth = reference::optical_depth(exact, {exact.radius(), h0, mu}, 0, end);
                ++all;
                if (segment.trust <= 0) continue;
                ++trusted;
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(segment.transmittance[c], std::exp(-depth[c]), 0.005 * std::exp(-depth[c]))
                        << h0 << " " << mu << " " << share << " " << c;
            }
    EXPECT_GT(trusted, all / 3);
}

TEST(Transmittance, without_air_nothing_is_lost) {
    Atmosphere const airless = test::no_air();
    test::Table const table = test::make_transmittance_table(airless);
    EXPECT_LT(sample_optical_depth(table.sampler(), airless, 0, 0).x, 1e-20f);
    test::Table const sunlight = test::make_sunlight_table(airless);
    EXPECT_EQ(sample_sun_transmittance(sunlight.sampler(), airless, 0, 0.5f), vec3(1));
    EXPECT_EQ(sample_sun_transmittance(sunlight.sampler(), airless, 0, -0.5f), vec3(0));
}
