#include "support/gauss_legendre.h"
#include "support/ground_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {

constexpr int ROUNDS = 24; // an order is worth 0.4 of the last on Earth, 0.8 on the dense planet

/// What comes back of the light of ground whose radiance is 1, and what leaves the air at its top; over pi.
struct Balance {
    vec3 returned, lost;
};

Balance balance_of(Atmosphere const& air) {
    test::ResponseTable const response(air, ROUNDS);
    float const top = air.top_altitude, wider = 1 + top / air.ground_radius;
    vec3 const down = sample_diffuse_irradiance(response.sampler(), air, 0, 1, 1, 1) / PI;
    vec3 const up = sample_diffuse_irradiance(response.sampler(), air, top, 1, -1, -1) / PI;
    return {down, up * wider * wider};
}

double radiance(Moments const& moments, SunwardDirection const& direction) {
    Moments const basis = moment_basis(direction);
    double sum = 0;
    for (int i = 0; i < LIGHT_PARTS; ++i) sum += double(dot(moments.part[i], basis.part[i]));
    return sum;
}

} // namespace

TEST(GroundResponse, without_air_is_the_ground_itself) {
    test::ResponseTable const response(test::no_air(), 1);
    LightMoments const light = sample_light_moments(response.sampler(), test::no_air(), 0, 1);
    EXPECT_NEAR(power32(light.root).x, 0.5, 1e-5);
    Moments const& red = light.channel[0];
    EXPECT_NEAR(red.part[0].y * 0.5, -std::sqrt(3.0) / 4, 1e-5); // the mean of root 3 mu over the lower half
    EXPECT_NEAR(red.part[1].x, 0, 1e-5);
    EXPECT_NEAR(red.part[2].x * 0.5, std::sqrt(7.0) / 16, 1e-4); // 20 zeniths
    EXPECT_EQ(red.part[0].z, 0);
    EXPECT_EQ(red.part[3], vec4(0));
    EXPECT_NEAR(sample_diffuse_irradiance(response.sampler(), test::no_air(), 0, 1, 1, 1).x, 0, 1e-3); // 20 zeniths
}

// What the ground sends out comes back or leaves.
TEST(GroundResponse, air_that_loses_nothing_returns_what_it_does_not_let_out) {
    for (Planet planet : {make_earth(), test::hazy_planet()}) {
        for (alpenglow::AirComponent& component : planet.air.components) component.absorption = dvec3(0);
        Balance const balance = balance_of(atmosphere_of(planet));
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(balance.returned[c] + balance.lost[c], 1, 0.01) << c; // 16 cells, and four degrees of the limb
            EXPECT_GT(balance.returned[c], 0.02) << c;
        }
        EXPECT_GT(balance.returned.z, balance.returned.x); // blue comes back most
    }
}

TEST(GroundResponse, air_that_absorbs_keeps_some) {
    for (Atmosphere const& air : {test::earth_air(), test::hazy_air(), test::dense_air(), atmosphere_of(test::motley_planet())}) {
        Balance const balance = balance_of(air);
        for (int c = 0; c < 3; ++c) {
            EXPECT_GT(balance.returned[c], 0.02) << c;
            EXPECT_LT(balance.returned[c] + balance.lost[c], 1.005) << c;
        }
    }
}

// The addition theorem: light that is even around the zenith keeps its radiance when its moments are taken around the sun.
TEST(GroundResponse, turned_to_the_sun_is_the_same_light) {
    Moments zonal = no_moments();
    zonal.part[0] = vec4(1, -0.4f, 0, 0.03f);
    zonal.part[1].x = 0.1f, zonal.part[2].x = -0.05f;
    for (float const mu_s : {0.9f, 0.3f, -0.1f, 1.0f}) {
        Moments const turned = turned_to_sun(zonal, mu_s);
        for (double const elevation : {-1.2, -0.3, 0.4, 1.0})
            for (double const azimuth : {0.2, 1.4, 2.9}) {
                double const mu = std::sin(elevation), sin_sun = std::sqrt(1 - double(mu_s) * mu_s);
                double const level = std::cos(elevation) * std::cos(azimuth);
                SunwardDirection const direction{float(mu * mu_s + level * sin_sun), float(mu * sin_sun - level * mu_s)};
                EXPECT_NEAR(radiance(turned, direction), radiance(zonal, {float(mu), 0}), 2e-6) << mu_s << " " << elevation;
            }
    }
}

// Without air ground is brighter by the difference of the albedos, whatever the altitude says.
TEST(GroundResponse, airless_ground_differs_by_its_albedo) {
    Atmosphere air = test::no_air();
    air.ground_albedo = vec3(0.2f);
    test::Table const clear(1, 1, [](vec2) { return vec4(0); });
    test::LightTable const light(air, clear.sampler(), GatherRays{2, 1, 6, 12});
    test::ResponseTable const response(air, 1);
    for (float const albedo : {0.0f, 0.2f, 0.7f}) {
        vec3 const found = ground_difference(air, clear.sampler(), light.sampler(), response.sampler(), vec3(albedo), 0, 0.8f);
        EXPECT_NEAR(found.x, (albedo - 0.2) * 0.8 / std::numbers::pi, 2e-4) << albedo;
    }
    vec3 const night = ground_difference(air, clear.sampler(), light.sampler(), response.sampler(), vec3(0.7f), 0, -0.3f);
    EXPECT_NEAR(night.x, 0, 1e-6);
}
