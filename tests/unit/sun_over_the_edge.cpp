#include "support/air.h"
#include "support/air_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace alpenglow;
using namespace alpenglow::shader;

namespace {

Atmosphere const AIR = test::earth_air();

/// The share of an even disc that a point sees past the planet, by asking 40 000 points of the disc, even in area, whether
/// their ray misses the sphere.
double share_by_rays(double h, double sun_zenith) {
    double const r = double(AIR.ground_radius) + h, planet = AIR.ground_radius;
    glm::dvec3 const to_sun(std::sin(sun_zenith), 0, std::cos(sun_zenith)), side(0, 1, 0), up = glm::cross(to_sun, side);
    constexpr int N = 200;
    int seen = 0;
    for (int i = 0; i < N * N; ++i) {
        double const radius = double(AIR.sun_angular_radius) * std::sqrt((i / N + 0.5) / N);
        double const around = 2 * std::numbers::pi * (i % N + 0.5) / N;
        glm::dvec3 const ray = glm::normalize(to_sun + radius * (std::cos(around) * side + std::sin(around) * up));
        double const along = r * ray.z;
        seen += along >= 0 || r * r - along * along >= planet * planet;
    }
    return seen / double(N * N);
}

double horizon_zenith(double h) {
    return std::numbers::pi / 2 + std::acos(double(AIR.ground_radius) / (double(AIR.ground_radius) + h));
}

} // namespace

// The curve of the edge and the second order of the angles are in this integral, and not in the function.
TEST(SunOverTheEdge, the_share_is_that_of_the_discs_area) {
    double worst = 0;
    for (double const h : {0.0, 2.0, 300.0, 3000.0, 12e3, 50e3, 100e3})
        for (double x = -1.2; x <= 1.2; x += 0.1) {
            double const zenith = horizon_zenith(h) - x * double(AIR.sun_angular_radius);
            auto const along = float((double(AIR.ground_radius) + h) * std::cos(zenith));
            worst = std::max(worst, std::abs(double(sun_above_horizon_along(AIR, float(h), along)) - share_by_rays(h, zenith)));
        }
    // 0.006 of the polynomial, 0.002 of the counted points and of float, which tells a sun's height to a hundredth of it.
    EXPECT_LT(worst, 0.008);
}

TEST(SunOverTheEdge, the_planets_shadow_has_a_soft_edge_in_the_air) {
    // Straight up at dusk: dark below, lit above, and between them as many metres of penumbra as the sun is wide.
    double const sun = -0.08; // [rad]
    auto const share = [&](double h) {
        return double(sun_above_horizon_along(AIR, float(h), float((double(AIR.ground_radius) + h) * std::sin(sun))));
    };
    double const radius = AIR.ground_radius, half = AIR.sun_angular_radius;
    double const first = radius / std::cos(-sun - half) - radius, last = radius / std::cos(-sun + half) - radius;
    EXPECT_EQ(share(first - 100), 0);
    EXPECT_EQ(share(last + 100), 1);
    double before = 0;
    for (double h = first; h <= last; h += (last - first) / 40) {
        EXPECT_GE(share(h), before);
        EXPECT_LT(share(h) - before, 0.05); // no step
        before = share(h);
    }
    EXPECT_GT(last - first, 4000); // [m]
}
