#include "models/tables/aerial_perspective.glsl"
#include "models/tables/sky_light.glsl"
#include "models/tables/sky_view.glsl"
#include "support/air.h"

#include <gtest/gtest.h>

#include <array>

using namespace alpenglow;
using namespace alpenglow::shader;
using test::earth_air;
using test::earth_sunlight;

namespace {

Atmosphere const AIR = earth_air();

test::Table const& isotropic_table() {
    static test::Table const table(ISOTROPIC_SIZE, ISOTROPIC_SIZE, [](vec2 uv) {
        vec2 const node = altitude_sun_from_uv(AIR, uv, ISOTROPIC_SIZE, ISOTROPIC_SIZE);
        return vec4(root32(compute_isotropic(AIR, earth_sunlight().sampler(), node.x, node.y)), 1);
    });
    return table;
}

} // namespace

TEST(TablesModel, directions_are_even) {
    constexpr int N = ISOTROPIC_DIRECTIONS;
    dvec3 mean(0), squares(0);
    for (int i = 0; i < N; ++i) {
        dvec3 const d(even_direction(i, N));
        EXPECT_NEAR(length(d), 1, 1e-6);
        mean += d / double(N), squares += d * d / double(N);
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean[c], 0, 0.02); // 64 points can't do better; with swapped angles the moments are 0.5, 0.25, 0.25
        EXPECT_NEAR(squares[c], 1.0 / 3, 0.01);
    }
}

TEST(TablesModel, sky_view_mapping_comes_back) {
    for (float const h : {0.0f, 1.0f, 900.0f, 12e3f, 99e3f}) {
        float const horizon = std::acos(horizon_mu(AIR.ground_radius, h));
        for (int y = 0; y < SKY_VIEW_HEIGHT; ++y) {
            for (int x = 0; x < SKY_VIEW_WIDTH; x += 7) {
                vec2 const uv((float(x) + 0.5f) / SKY_VIEW_WIDTH, (float(y) + 0.5f) / SKY_VIEW_HEIGHT);
                SkyDirection const direction = sky_direction_from_uv(AIR, h, uv);
                bool const below = std::acos(direction.mu) > horizon;
                EXPECT_EQ(below, y >= SKY_VIEW_HEIGHT / 2) << h << " m, row " << y;
                vec2 const back = sky_view_uv(AIR, h, direction, below);
                // Half a row is 0.005: an angle's cosine is good to 1e-3 of it beside the zenith and the horizon.
                EXPECT_NEAR(back.x, uv.x, 1e-3f);
                EXPECT_NEAR(back.y, uv.y, 1e-3f) << h << " m, row " << y;
            }
        }
    }
}

TEST(TablesModel, sky_view_is_dense_at_the_horizon) {
    // The two rows beside the horizon are within a hundredth of a degree of it, those at the ends of each half are two
    // degrees apart.
    auto const zenith = [](int row) {
        return degrees(std::acos(sky_direction_from_uv(AIR, 1000, {0.5f, (float(row) + 0.5f) / SKY_VIEW_HEIGHT}).mu));
    };
    EXPECT_NEAR(zenith(SKY_VIEW_HEIGHT / 2) - zenith(SKY_VIEW_HEIGHT / 2 - 1), 0.016f, 0.005f);
    EXPECT_GT(zenith(1) - zenith(0), 2.0f);
}

TEST(TablesModel, squared_cells_tile_the_ray) {
    // Nothing of a ray is left out: a thin medium's light is its length times its source.
    Planet planet = make_earth();
    planet.air.components = {test::rayleigh_component(glm::dvec3(1e-12), 1e12)};
    Atmosphere const even = atmosphere_of(planet);
    std::array<vec4, 4> const nothing{};
    sampler2D const none{2, 2, nothing.data()};
    AirRay const up = make_air_ray(even.ground_radius, 0, 1, 1, 1);
    AirLight const light = march_squared(even, none, none, up, 1e5f, 30);
    EXPECT_NEAR(light.inscattered.x / (1e-12f * draine_phase(1, 0, 1) * 1e5f), 1, 1e-5);
}

TEST(TablesModel, further_orders_are_a_share_of_the_first) {
    // Overhead sun on Earth's ground: two tenths of the light around are blue light of further orders.
    vec3 const psi = sample_isotropic(isotropic_table().sampler(), AIR, 0, 1);
    for (int c = 0; c < 3; ++c) EXPECT_GT(psi[c], 0);
    EXPECT_GT(psi.z, psi.x);
    EXPECT_LT(psi.z, 0.2f);
    vec3 const night = sample_isotropic(isotropic_table().sampler(), AIR, 0, -0.3f);
    EXPECT_LT(night.z, 1e-5f);
}

TEST(TablesModel, sky_light_is_the_sky_views_integral) {
    constexpr float MU_S = 0.5f;
    sampler2D const sunlight = earth_sunlight().sampler(), isotropic = isotropic_table().sampler();
    vec3 const expected = compute_sky_light(AIR, sunlight, isotropic, 0, MU_S);
    dvec3 sum(0);
    constexpr int RINGS = 48, SPOKES = 64;
    for (int i = 0; i < RINGS * SPOKES; ++i) {
        float const mu = (float(i / SPOKES) + 0.5f) / RINGS, azimuth = (float(i % SPOKES) + 0.5f) / SPOKES * 2 * PI;
        sum += dvec3(compute_sky_view(AIR, sunlight, isotropic, 0, MU_S, {mu, std::cos(azimuth)}) * mu) * (2.0 * PI / (RINGS * SPOKES));
    }
    // The squared spacing of 30 cells is some percents off where the aerosol is bright; a factor is far more.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 0.06 * expected[c]) << c;
}

TEST(TablesModel, aerial_perspective_follows_distance) {
    // A table whose slices hold their own distance.
    constexpr float REACH = 2e5f;
    test::Table const table(AERIAL_SLICES * AERIAL_SIZE, 2 * AERIAL_SIZE, [](vec2 uv) {
        float const distance = aerial_distance(REACH, int(uv.x * AERIAL_SLICES));
        return vec4(vec3(uv.y < 0.5f ? distance : 1 - distance / REACH), 1);
    });
    for (float const distance : {0.0f, 50.0f, 195.3f, 1000.0f, 33e3f, 2e5f}) {
        for (float const edge : {0.0f, 0.3f, 1.0f}) {
            AirLight const light = sample_aerial_perspective(table.sampler(), REACH, {edge, 1 - edge}, distance);
            // Linear between the ends of slices, which are evenly spaced in the root of the distance.
            EXPECT_NEAR(light.inscattered.x, distance, 0.03f * distance + 100);
            EXPECT_NEAR(light.transmittance.x, 1 - distance / REACH, 0.002f);
        }
    }
}
