#include "reference/optical_depth.h"
#include "support/components.h"
#include "support/single_scattering.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

Planet small_planet(double radius) {
    Planet planet = make_earth();
    planet.radius = radius;
    planet.air.top_altitude = 6e4;
    return planet;
}

double largest(dvec3 const& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

} // namespace

TEST(ReferenceDepth, transmittance_to_the_top_is_within_a_millionth_of_quadrature) {
    for (Planet const& planet : {make_earth(), dense_planet(), motley_planet(), small_planet(6e5), small_planet(1e5)}) {
        Medium const medium = make_medium(planet);
        OpticalDepth const depth(medium);
        SingleScatteringQuadrature const quadrature(planet, 20);
        double worst = 0;
        for (int i = 0; i <= 60; ++i) {
            double const h = planet.air.top_altitude * i * i / 3600.0 * 0.9999, r = planet.radius + h;
            double const horizon = -std::sqrt(1 - std::pow(planet.radius / r, 2));
            for (int k = 0; k <= 200; ++k) {
                // Denser at the horizon, and a millionth above it.
                double const x = k / 200.0, mu = horizon + (1 - horizon) * std::max(1e-6, x * x * x);
                dvec3 const exact = quadrature.depth_to({0, 0, r}, {std::sqrt(1 - mu * mu), 0, mu});
                // Transmittance exp(-depth) is relatively off by the depth's own error.
                worst = std::max(worst, largest(depth.to_top(r, mu) - exact));
            }
        }
        EXPECT_LT(worst, 1e-6) << planet.radius << " " << planet.air.components.front().name;
    }
}

TEST(ReferenceDepth, parts_of_a_ray_are_within_a_millionth_of_quadrature) {
    Planet const earth = make_earth();
    OpticalDepth const depth(make_medium(earth));
    SingleScatteringQuadrature const quadrature(earth, 20);
    for (double const elevation : {-0.2, 0.0, 0.4, 10.0, 90.0}) {
        double const e = glm::radians(elevation);
        Ray const ray({0, 0, earth.radius + 2e3}, {std::cos(e), 0, std::sin(e)});
        DepthAlong const along(depth, ray);
        for (double const end : {10.0, 5e3, 2e4, 9e4}) {
            dvec3 const exact = quadrature.depth(ray.origin, ray.direction, 0, end);
            EXPECT_LT(largest(glm::abs(along.at(end) - along.at(0)) - exact), 1e-6) << elevation << ", " << end;
        }
    }
}
