#include "support/components.h"
#include "support/single_scattering.h"
#include "support/traced_world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

/// Relative; the tracer's transmittances are that good.
constexpr double ROUNDING = 1e-6;

dvec3 towards(double elevation, double azimuth) {
    double const e = glm::radians(elevation), a = glm::radians(azimuth);
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

struct Comparison {
    std::vector<std::string> wrong{}; ///< channels of rays outside the bound
    int noisy = 0;                    ///< rays whose noise would hide an error of 3 %
    int rays = 0;
    ChiSquare together{}; ///< of the blue channel
};

/// Rays from altitude h [m] with the sun at an elevation [degrees] over the place below, traced in `traced`, against
/// the quadrature in `planet`.
Comparison compare(Planet const& planet, Planet const& traced, double h, double sun_elevation,
                   std::vector<double> const& elevations) {
    SingleScatteringQuadrature const quadrature(planet);
    LightSource const light{.to_sun = towards(sun_elevation, 0)};
    TracedWorld const world(traced, light, 1);
    Comparison result;
    for (double const elevation : elevations)
        for (double const azimuth : {0.0, 60.0, 180.0}) {
            Sightline const s{{0, 0, planet.radius + h}, towards(elevation, azimuth), light.to_sun};
            SingleScattering const parts = quadrature(s);
            dvec3 const exact = parts.air + parts.ground;
            auto const seed = static_cast<std::uint64_t>(result.rays++);
            Measured const m = measure(world.tracer, s.origin, s.direction, 64, seed);
            for (int c = 0; c < 3; ++c)
                if (!(std::abs(m.mean[c] - exact[c]) <= BOUND * m.deviation[c] + ROUNDING * exact[c]))
                    result.wrong.push_back(fmt::format("{} m, sun {}, ray {} / {}, channel {}: {} for {}, deviation {}",
                                                       h, sun_elevation, elevation, azimuth, c, m.mean[c], exact[c],
                                                       m.deviation[c]));
            result.noisy += m.deviation.z * BOUND > 0.03 * exact.z;
            if (exact.z > 0)
                result.together.add(m.mean.z - exact.z, std::pow(m.deviation.z, 2) + std::pow(ROUNDING * exact.z, 2));
        }
    return result;
}

void expect_equal(double h, std::vector<double> const& suns, std::vector<double> const& elevations) {
    Planet const earth = make_earth();
    for (double const sun : suns) {
        Comparison const all = compare(earth, earth, h, sun, elevations);
        for (std::string const& text : all.wrong) ADD_FAILURE() << text;
        EXPECT_GT(all.together.tail(), 1e-4) << h << " m, sun " << sun;
        EXPECT_LT(all.noisy, all.rays / 2) << h << " m, sun " << sun;
    }
}

} // namespace

TEST(ReferenceSingleScattering, from_the_ground) { expect_equal(0, {60, 4}, {-2, 0.3, 8, 45, 89}); }
TEST(ReferenceSingleScattering, from_10_km) { expect_equal(1e4, {60, 4}, {-80, -20, -3.1, -1, 5, 60}); }
TEST(ReferenceSingleScattering, from_400_km) { expect_equal(4e5, {60, 10}, {-85, -40, -21, -19.5, -18.5}); }

TEST(ReferenceSingleScattering, from_the_ground_in_the_planets_shadow) { expect_equal(0, {-2, -7}, {1, 15, 60}); }
TEST(ReferenceSingleScattering, from_10_km_in_the_planets_shadow) { expect_equal(1e4, {-4, -8}, {-4, -1, 5, 40}); }
TEST(ReferenceSingleScattering, from_400_km_across_the_planets_shadow) {
    expect_equal(4e5, {-10, -25}, {-40, -20.5, -19.5, -18.5});
}

TEST(ReferenceSingleScattering, of_a_disc_is_the_mean_over_its_points) {
    // Six times as wide as the sun's, and half below the horizon.
    Planet const earth = make_earth();
    LightSource const light{.to_sun = towards(0, 0), .angular_radius = 0.03};
    SingleScatteringQuadrature const quadrature(earth);
    TracedWorld const world(earth, light, 1);
    constexpr int RINGS = 12, SPOKES = 24;
    std::uint64_t seed = 900;
    for (double const elevation : {2.0, 30.0}) {
        Sightline s{{0, 0, earth.radius}, towards(elevation, 70), {}};
        dvec3 exact(0);
        for (int i = 0; i < RINGS * SPOKES; ++i) {
            double const r = light.angular_radius * std::sqrt((i / SPOKES + 0.5) / RINGS);
            double const turn = (i % SPOKES + 0.5) / SPOKES * 2 * std::numbers::pi;
            s.to_sun = glm::normalize(dvec3(1, r * std::cos(turn), r * std::sin(turn)));
            exact += quadrature(s).air / double(RINGS * SPOKES);
        }
        Measured const m = measure(world.tracer, s.origin, s.direction, 512, seed++);
        // Twice the rings and spokes move the sum by 3e-5 at most.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(m.mean[c], exact[c], BOUND * m.deviation[c] + 5e-5 * exact[c]);
        s.to_sun = light.to_sun;
        EXPECT_GT(std::abs(quadrature(s).air.x - exact.x), 2 * BOUND * m.deviation.x); // a point is not a disc
    }
}

TEST(ReferenceSingleScattering, of_every_profile_and_phase) {
    Planet const motley = motley_planet();
    for (double const h : {0.0, 2e4}) {
        Comparison const all = compare(motley, motley, h, 20, {-15, 1, 8, 45, 89});
        for (std::string const& text : all.wrong) ADD_FAILURE() << text;
        EXPECT_GT(all.together.tail(), 1e-4) << h;
        EXPECT_LT(all.noisy, all.rays / 2) << h;
    }
}

TEST(ReferenceSingleScattering, three_percent_more_rayleigh_is_found) {
    Planet const earth = make_earth();
    Planet thicker = earth;
    thicker.air.at("rayleigh").scattering *= 1.03;
    Comparison const all = compare(earth, thicker, 0, 60, {8, 45, 89});
    EXPECT_GT(all.wrong.size(), 9u); // of 27
    EXPECT_LT(all.together.tail(), 1e-6);
}
