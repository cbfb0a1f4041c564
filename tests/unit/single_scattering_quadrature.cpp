#include "support/components.h"
#include "support/single_scattering.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

/// A sight from altitude h [m] over the pole; angles in degrees, azimuth from the sun's.
Sightline sight(Planet const& planet, double h, double elevation, double azimuth, double sun_elevation) {
    auto const towards = [](double e, double a) {
        e = glm::radians(e), a = glm::radians(a);
        return dvec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    };
    return {{0, 0, planet.radius + h}, towards(elevation, azimuth), towards(sun_elevation, 0)};
}

std::vector<Sightline> sights(Planet const& planet) {
    std::vector<Sightline> all;
    for (double const h : {0.0, 1e4, 4e5})
        for (double const elevation : {-80.0, -19.5, -3.0, 0.3, 5.0, 40.0})
            for (double const sun : {-6.0, -1.0, 4.0, 60.0})
                for (double const azimuth : {0.0, 70.0, 180.0})
                    all.push_back(sight(planet, h, elevation, azimuth, sun));
    return all;
}

/// One medium of constant density, as flat as doubles allow.
Planet flat_layer(double thickness, double depth, double albedo) {
    Planet planet;
    planet.radius = 1e9;
    planet.air.top_altitude = thickness;
    AirComponent even = rayleigh_component(dvec3(depth * albedo / thickness), 1e15);
    even.absorption = dvec3(depth * (1 - albedo) / thickness);
    planet.air.components = {even};
    planet.ground_albedo = dvec3(0);
    return planet;
}

double largest(dvec3 const& v) { return std::max({v.x, v.y, v.z}); }

} // namespace

TEST(SingleScatteringQuadrature, does_not_change_with_twice_the_nodes) {
    Planet const earth = make_earth();
    SingleScatteringQuadrature const coarse(earth), fine(earth, 20);
    for (Sightline const& s : sights(earth)) {
        SingleScattering const a = coarse(s), b = fine(s);
        // What is darker than 1e-12 of the sun is nothing.
        EXPECT_LT(largest(glm::abs(a.air / glm::max(b.air, 1e-12) - b.air / glm::max(b.air, 1e-12))), 1e-7);
        EXPECT_LT(largest(glm::abs(a.ground - b.ground) / glm::max(b.ground, 1e-12)), 1e-7);
    }
}

TEST(SingleScatteringQuadrature, depth_of_the_zenith_is_the_closed_form) {
    Planet const earth = make_earth();
    Air const& air = earth.air;
    auto const column = [&](AirComponent const& component, double scale_height) {
        return component.extinction() * scale_height * -std::expm1(-air.top_altitude / scale_height);
    };
    dvec3 const exact =
        column(air.at("rayleigh"), 8000) + column(air.at("aerosol"), 1200) + air.at("ozone").absorption * 15000.0;
    dvec3 const depth = SingleScatteringQuadrature(earth).depth_to({0, 0, earth.radius}, {0, 0, 1});
    // A point's altitude is a difference of two numbers of 6e6 m: 1e-9 m of a scale height of 1 km.
    EXPECT_LT(largest(glm::abs(depth / exact - 1.0)), 1e-11);
}

TEST(SingleScatteringQuadrature, depth_of_a_constant_medium_is_its_chord) {
    Planet planet = flat_layer(5e4, 2, 1);
    planet.radius = 6e6;
    for (double const h : {0.0, 300.0, 4e4}) {
        double const r = planet.radius + h, top = planet.radius + 5e4;
        dvec3 const depth = SingleScatteringQuadrature(planet).depth_to({0, 0, r}, {1, 0, 0});
        EXPECT_NEAR(depth.x, std::sqrt(top * top - r * r) * 2 / 5e4, 1e-8 * depth.x) << h;
    }
}

TEST(SingleScatteringQuadrature, flat_layers_reflect_and_transmit_by_the_closed_form) {
    double const depth = 0.7, albedo = 0.8, mu = 0.6, mu0 = 0.5;
    Planet const layer = flat_layer(100, depth, albedo);
    Sightline s{{0, 0, layer.radius + 100}, {-std::sqrt(1 - mu * mu), 0, -mu}, {std::sqrt(1 - mu0 * mu0), 0, mu0}};
    auto const phase = [&] { return 3 / (16 * std::numbers::pi) * (1 + std::pow(glm::dot(s.direction, s.to_sun), 2)); };
    double const reflected = albedo * phase() * mu0 / (mu + mu0) * -std::expm1(-depth * (1 / mu + 1 / mu0));
    // Curvature: 1e-7, thickness over radius. Altitude: doubles of 1e9 m are 1e-7 m apart.
    EXPECT_NEAR(SingleScatteringQuadrature(layer)(s).air.x, reflected, 1e-6 * reflected);
    s.origin.z = layer.radius, s.direction.z = mu;
    double const transmitted = albedo * phase() * mu0 / (mu - mu0) * (std::exp(-depth / mu) - std::exp(-depth / mu0));
    EXPECT_NEAR(SingleScatteringQuadrature(layer)(s).air.x, transmitted, 1e-6 * transmitted);
}

TEST(SingleScatteringQuadrature, shadowed_rays_meet_a_plain_sum) {
    Planet const earth = make_earth();
    SingleScatteringQuadrature const quadrature(earth);
    for (Sightline const& s : {sight(earth, 0, 20, 150, -4), sight(earth, 4e5, -18, 30, -9)}) {
        auto const [start, end, ground] = quadrature.segment(s.origin, s.direction);
        int const n = 4000;
        double const step = (end - start) / n, nu = glm::dot(s.direction, s.to_sun);
        double sum = 0, depth = 0;
        for (int i = 0; i < n; ++i) {
            dvec3 const p = s.origin + (start + (i + 0.5) * step) * s.direction;
            double const h = glm::length(p) - earth.radius, slice = step * quadrature.extinction(h).z;
            bool const shadow = glm::dot(p, s.to_sun) < 0 && glm::length(glm::cross(p, s.to_sun)) < earth.radius;
            double const g = 0.8;
            double const rayleigh = earth.air.at("rayleigh").scattering.z * std::exp(-h / 8000) * 3 / 16 * (1 + nu * nu);
            double const aerosol = earth.air.at("aerosol").scattering.z * std::exp(-h / 1200) * 3 / 8 * (1 - g * g) *
                                   (1 + nu * nu) / (2 + g * g) / std::pow(1 + g * g - 2 * g * nu, 1.5);
            if (!shadow)
                sum += step * (rayleigh + aerosol) / std::numbers::pi *
                       std::exp(-depth - slice / 2 - quadrature.depth_to(p, s.to_sun).z);
            depth += slice;
        }
        // The shadow's edge falls within one of 4000 steps.
        EXPECT_NEAR(quadrature(s).air.z, sum, 1e-3 * sum);
    }
}

TEST(SingleScatteringQuadrature, bare_ground_reflects_as_lambert) {
    Planet planet = flat_layer(100, 1e-12, 1);
    planet.ground_albedo = dvec3(0.3);
    SingleScattering const light = SingleScatteringQuadrature(planet)(sight(planet, 50, -60, 20, 30));
    // The sight falls 30 m from the pole: the sun's height there is the pole's to 1e-7.
    EXPECT_NEAR(light.ground.x, 0.3 / std::numbers::pi * 0.5, 1e-6);
}
