#include "support/air.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {

/// Few directions: fixed points, order and symmetry do not depend on them. As many cells as the tables have: fewer are one run,
/// whose parabola dips by more.
constexpr GatherRays FEW_FIRST = {2, 1, 6, 12}, FEW_HIGHER = {1, 1, 4, 16};

/// Even light of radiance 1/sr everywhere.
test::Table const& furnace_light() {
    static test::Table const table(1, LIGHT_TILES * MULTIPLE_SCATTERING_HEIGHT, [](vec2 uv) {
        return int(uv.y * LIGHT_TILES) % LIGHT_PARTS == 0 ? vec4(1, 0, 0, 0) : vec4(0);
    });
    return table;
}

/// Air and ground that lose nothing.
Atmosphere lossless(Planet planet) {
    planet.ground_albedo = dvec3(1);
    for (alpenglow::AirComponent& component : planet.air.components) component.absorption = dvec3(0);
    return atmosphere_of(planet);
}

/// With the extinction of light that has been scattered before.
Atmosphere delta_scaled(Atmosphere air) {
    for (shader::AirComponent& component : air.content.components)
        component.extinction -= component.scattering * (1 - component.moments.degree[0]);
    return air;
}

void expect_even_light_to_stay_even(Atmosphere const& air, double tolerance) {
    Atmosphere const scaled = delta_scaled(air);
    for (float const h : {0.0f, 3000.0f, 40e3f})
        for (float const mu : {-0.99f, -0.5f, -0.2f, 0.01f, 0.3f, 1.0f}) {
            AirRay const ray = make_air_ray(air.ground_radius, h, mu, 0.4f, 0.4f * mu + 0.1f);
            AirSegment const segment = air_segment(air, ray);
            vec3 const depth = compute_optical_depth(scaled, ray, 0, segment.end);
            EXPECT_LE(depth.x, compute_optical_depth(air, ray, 0, segment.end).x);
            vec3 const light = scattered_light(air, furnace_light().sampler(), ray, 64);
            for (int c = 0; c < 3; ++c) {
                double const exact = segment.hits_ground ? 1 : -std::expm1(-double(depth[c]));
                EXPECT_NEAR(light[c], exact, tolerance * exact) << h << " " << mu;
            }
        }
}

/// Optical depth 0 everywhere.
sampler2D clear() {
    static test::Table const table(1, 1, [](vec2) { return vec4(0); });
    return table.sampler();
}

} // namespace

// Between white ground and air that loses nothing even light stays even: a ray to the ground brings what it went out with,
// whatever the phases, and one to space lacks what it would have let in.
TEST(MultipleScattering, even_light_in_a_furnace_stays_even) {
    expect_even_light_to_stay_even(lossless(make_earth()), 0.002);
    // 64 cells do not follow the edges of a shell.
    expect_even_light_to_stay_even(lossless(test::motley_planet()), 0.015);
}

// Below, in deep night, a run's parabola across all of twilight may dip: 32nd root of a ten millionth of the sun's light.
constexpr float DARKEST = 0.604f;

TEST(MultipleScattering, every_node_is_finite_and_every_order_adds_light) {
    for (Atmosphere const& air : {test::earth_air(), test::dense_air(), atmosphere_of(test::motley_planet())}) {
        test::Table const sunlight = test::make_sunlight_table(air);
        test::LightTable light(air, sunlight.sampler(), FEW_FIRST);
        for (int round = 0; round < 2; ++round) {
            std::vector<vec4> const before = light.texels();
            light.add_order(air, FEW_HIGHER);
            for (std::size_t i = 0; i < before.size(); ++i) {
                vec4 const texel = light.texels()[i];
                ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z + texel.w));
                if (i / test::LightTable::nodes() % LIGHT_PARTS != 0) continue; // not a tile with a mean
                if (before[i].x < DARKEST) continue;
                ASSERT_GE(texel.x, before[i].x * (1 - 1e-6f));
                ASSERT_LT(texel.x, std::pow(1 / PI, 1.0f / 32)); // a white world under a full sun
            }
        }
    }
}

TEST(MultipleScattering, without_air_and_on_black_ground_there_is_no_light) {
    Atmosphere air = test::no_air();
    air.ground_albedo = vec3(0);
    test::LightTable const light(air, clear(), FEW_FIRST);
    EXPECT_LT(sample_diffuse_irradiance(light.sampler(), air, 0, 0.5f, 1, 0.5f).x, 1e-20f);
}

// Ground without air: half of all directions hold the sun's light by Lambert's law.
TEST(MultipleScattering, light_from_airless_ground_is_known) {
    Atmosphere air = test::no_air();
    air.ground_albedo = vec3(0.3f);
    test::LightTable const light(air, clear(), GatherRays{2, 2, 6, 12}); // all the light is below
    vec3 const root = sample_light_moments(light.sampler(), air, 0, 0.8f).root;
    EXPECT_NEAR(power32(root).x, 0.5 * 0.3 * 0.8 / std::numbers::pi, 2e-4);
    EXPECT_NEAR(sample_diffuse_irradiance(light.sampler(), air, 0, 0.8f, -1, -0.8f).x, 0.3 * 0.8, 1e-3);
    EXPECT_NEAR(sample_diffuse_irradiance(light.sampler(), air, 0, 0.8f, 1, 0.8f).x, 0, 1e-3);
}

TEST(MultipleScattering, a_geometric_series_is_extrapolated_exactly) {
    auto const sum_of = [](int orders, float share) {
        float sum = 0, order = 1;
        for (int i = 0; i < orders; ++i) sum += order, order *= share;
        return Moments{{vec4(1, 0.5f, 0, 0) * sum, vec4(-0.1f) * sum, vec4(0), vec4(0.2f) * sum}};
    };
    for (float const share : {0.0f, 0.4f, 0.85f}) {
        Moments const all = extrapolated_moments(sum_of(3, share), sum_of(4, share), sum_of(5, share));
        EXPECT_NEAR(all.part[0].x, 1 / (1 - share), 1e-4);
        EXPECT_NEAR(all.part[0].y, 0.5f / (1 - share), 1e-4);
        EXPECT_NEAR(all.part[1].w, -0.1f / (1 - share), 1e-4);
        EXPECT_NEAR(all.part[3].z, 0.2f / (1 - share), 1e-4);
    }
    Moments const same = sum_of(5, 0.5f);
    EXPECT_EQ(extrapolated_moments(same, same, same).part[0], same.part[0]);
}

TEST(MultipleScattering, the_mapping_goes_there_and_back) {
    Atmosphere const air = test::earth_air();
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 64; ++x) {
            vec2 const uv((float(x) + 0.5f) / 64, (float(y) + 0.5f) / 16);
            vec2 const node = altitude_sun_from_uv(air, uv, 64, 16);
            vec2 const back = sun_table_uv(air, node.x, node.y, 64, 16);
            EXPECT_NEAR(back.x, uv.x, 1e-5);
            EXPECT_NEAR(back.y, uv.y, 1e-5);
        }
}
