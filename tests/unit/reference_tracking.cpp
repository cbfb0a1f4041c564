#include "reference/tracking.h"
#include "support/components.h"
#include "support/single_scattering.h"
#include "support/traced_world.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

unsigned const FLIGHTS = long_proofs() ? 2500000 : 100000;

/// Distances of first collisions, as the transmittance up to them: even in (T, 1], and T of them all get through.
struct Flights {
    ChiSquare even;
    double through = 0, expected = 0; ///< shares
};

Flights fly(Planet const& flown, Planet const& planet, dvec3 const& origin, dvec3 const& direction, int channel) {
    constexpr int BINS = 20;
    SingleScatteringQuadrature const quadrature(planet);
    Tracking const tracking(make_medium(flown));
    Ray const ray(origin, direction);
    auto const [start, end, ground] = quadrature.segment(origin, direction);
    double const transmittance = std::exp(-quadrature.depth(origin, direction, start, end)[channel]);
    std::vector<double> hits(BINS);
    for (std::uint64_t key = 0; key < FLIGHTS; ++key) {
        PathNumbers numbers(key, 0);
        auto const hit = tracking.fly(ray, start, end, channel, numbers);
        if (!hit) continue;
        double const collided = -std::expm1(-quadrature.depth(origin, direction, start, *hit)[channel]);
        ++hits.at(static_cast<std::size_t>(std::min(BINS - 1.0, collided / (1 - transmittance) * BINS)));
    }
    Flights result{.even = {}, .through = double(FLIGHTS), .expected = transmittance};
    for (double const n : hits) {
        double const mean = FLIGHTS * (1 - transmittance) / BINS;
        result.even.add(n - mean, mean * (1 - mean / FLIGHTS));
        result.through -= n;
    }
    result.through /= FLIGHTS;
    return result;
}

dvec3 up(double elevation) { return {std::cos(glm::radians(elevation)), 0, std::sin(glm::radians(elevation))}; }

double deviation(Flights const& f) { return std::sqrt(f.expected * (1 - f.expected) / FLIGHTS); }

} // namespace

TEST(ReferenceTracking, flights_have_the_transmittance_of_quadrature) {
    Planet const earth = make_earth(), motley = motley_planet();
    auto const check = [&](Planet const& planet, double h, double elevation) {
        for (int channel = 0; channel < 3; ++channel) {
            Flights const f = fly(planet, planet, {0, 0, planet.radius + h}, up(elevation), channel);
            EXPECT_NEAR(f.through, f.expected, 4.5 * deviation(f)) << h << " m, " << elevation;
            EXPECT_GT(f.even.tail(), 1e-4) << h << " m, " << elevation;
        }
    };
    check(earth, 0, 90);
    check(earth, 0, 1);
    check(earth, 1e4, -2);    // down to 6 km and up again
    check(earth, 1e4, -40);   // to the ground
    check(motley, 0, 1);
    check(motley, 2e4, -3); // along the shell and down through the mist
    check(earth, 4e5, -19.6); // in from space, through the ozone, 13 km over the ground
}

TEST(ReferenceTracking, three_percent_more_rayleigh_is_found) {
    Planet const earth = make_earth();
    Planet thicker = earth;
    thicker.air.at("rayleigh").scattering *= 1.03;
    Flights const f = fly(thicker, earth, {0, 0, earth.radius}, up(20), 2);
    EXPECT_GT(std::abs(f.through - f.expected), 4.5 * deviation(f));
}
