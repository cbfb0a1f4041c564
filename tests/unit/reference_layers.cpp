#include "support/half_space.h"
#include "support/rayleigh_layers.h"
#include "support/traced_world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// Plane-parallel layers, as a thin shell around a huge planet: 10 m on 1e9 m. Over a slant path the zenith's cosine mu
/// turns by thickness / (radius mu): the flat laws hold within thickness / (radius mu^2), relatively.
using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr double RADIUS = 1e9, THICKNESS = 10;

double curvature(double mu) { return THICKNESS / (RADIUS * mu * mu); }

Planet bare(double albedo) {
    Planet planet;
    planet.radius = RADIUS;
    planet.look = GroundLook::uniform;
    planet.ground_albedo = glm::dvec3(albedo);
    return planet;
}

/// A shell of constant density.
Medium layer(double depth, double albedo, Phase const& phase) {
    LinearProfile const even{{{0, 1}, {THICKNESS, 1}}};
    return {RADIUS, THICKNESS, {{glm::dvec3(albedo * depth / THICKNESS), glm::dvec3(depth / THICKNESS), even, lobes_of(phase)}}};
}

glm::dvec3 slanted(double mu, double azimuth = 0) {
    double const across = std::sqrt(1 - mu * mu);
    return {across * std::cos(azimuth), across * std::sin(azimuth), mu};
}

glm::dvec3 const TOP(0, 0, RADIUS + THICKNESS), BOTTOM(0, 0, RADIUS);

/// Radiance that goes up from the top at the cosine mu in the azimuth of travel, for a beam of irradiance 1 that
/// travels in azimuth 0.
Measured reflected(PathTracer const& tracer, double mu, double azimuth, int paths, std::uint64_t seed) {
    return measure(tracer, TOP, -slanted(mu, azimuth), paths, seed);
}

LightSource beam(double mu0, double irradiance = 1) {
    glm::dvec3 const sideways = slanted(mu0);
    return {.to_sun = {-sideways.x, 0, mu0}, .irradiance = glm::dvec3(irradiance)};
}

void expect_near(Measured const& m, double exact, double slack, std::string const& what) {
    EXPECT_NEAR(m.mean.y, exact, BOUND * m.deviation.y + slack * exact) << what;
    EXPECT_LT(m.deviation.y, 0.03 * exact) << what; // else nothing is proved
}

} // namespace

TEST(ReferenceLayers, half_space_without_absorption_is_chandrasekhars) {
    // Deep in such a half space light is even in all directions, and a white Lambert ground makes no difference to
    // that: a layer of depth 12 over it differs from the half space by e^-12.
    HFunction const h;
    Planet const white = bare(1);
    Medium const medium = layer(8, 1, {.kind = Phase::Kind::isotropic});
    std::uint64_t seed = 1;
    double together = 0, variance = 0;
    for (double const mu0 : {0.2, 0.5, 1.0}) {
        TracedWorld const world(white, medium, beam(mu0), 0);
        for (double const mu : {0.1, 0.4, 0.8, 1.0}) {
            double const exact = h.reflected(mu, mu0);
            Measured const m = reflected(world.tracer, mu, 1.0, 96, seed++);
            expect_near(m, exact, 4e-4, fmt::format("mu {}, mu0 {}", mu, mu0));
            together += m.mean.y / exact / 12, variance += std::pow(m.deviation.y / exact / 12, 2);
        }
    }
    EXPECT_NEAR(together, 1, BOUND * std::sqrt(variance) + 4e-4);
    EXPECT_LT(std::sqrt(variance), 0.007);
}

TEST(ReferenceLayers, half_space_with_a_percent_of_absorption_is_another) {
    HFunction const h;
    TracedWorld const world(bare(1), layer(8, 0.99, {.kind = Phase::Kind::isotropic}), beam(0.5), 0);
    Measured const m = reflected(world.tracer, 0.8, 1.0, 192, 77);
    EXPECT_LT(m.mean.y + BOUND * m.deviation.y, h.reflected(0.8, 0.5));
}

TEST(ReferenceLayers, finite_rayleigh_layers_are_the_published_ones) {
    Planet const black = bare(0);
    std::uint64_t seed = 100;
    for (RayleighLayer const& published : SWEIGART_LAYERS) {
        Medium const medium = layer(published.depth, published.albedo, {.kind = Phase::Kind::rayleigh});
        TracedWorld const world(black, medium, beam(SWEIGART_MU0, std::numbers::pi), 0);
        // A thick layer lets little through, and much of the noise of what does not.
        int const paths = published.depth > 1 ? 256 : 64;
        for (std::size_t i = 0; i < SWEIGART_MU.size(); ++i) {
            double const mu = SWEIGART_MU[i], slack = 1e-5 + curvature(std::min(mu, SWEIGART_MU0));
            std::string const what = fmt::format("depth {}, albedo {}, mu {}", published.depth, published.albedo, mu);
            expect_near(reflected(world.tracer, mu, 0, paths, seed++), published.up[i], slack, what + " up");
            Measured const down = measure(world.tracer, BOTTOM, -slanted(-mu), paths, seed++);
            EXPECT_NEAR(down.mean.y, published.down[i], BOUND * down.deviation.y + slack * published.down[i])
                << what << " down, deviation " << down.deviation.y;
        }
    }
}

TEST(ReferenceLayers, isotropic_layers_are_the_published_ones) {
    // DISORT's test problem 1e, as cdisort's disotest.c prints it (there after van de Hulst 1980, table 12).
    TracedWorld const world(bare(0), layer(32, 1, {.kind = Phase::Kind::isotropic}), beam(0.1, std::numbers::pi / 0.1),
                            0);
    for (auto const& [mu, up] : {std::pair{0.1, 1.93321}, {0.5, 1.02732}, {1.0, 0.797199}})
        expect_near(reflected(world.tracer, mu, 0, 256, 200), up, 1e-5 + curvature(0.1), fmt::format("mu {}", mu));
}

TEST(ReferenceLayers, camera_and_sun_change_places) {
    // A mixture of lobes over grey ground: the reflected radiance over the incoming cosine is symmetric.
    Medium mixture = layer(1.5, 0.95, {.kind = Phase::Kind::rayleigh});
    LinearProfile const low{{{0, 2}, {4, 2}}};
    mixture.components.push_back(
        {glm::dvec3(0.3, 0.2, 0.1), glm::dvec3(0.3, 0.25, 0.1), low, lobes_of({.kind = Phase::Kind::cornette_shanks, .g = 0.7})});
    Planet const grey = bare(0.4);
    std::uint64_t seed = 300;
    for (auto const& [a, b, azimuth] : {std::tuple{0.2, 0.9, 0.3}, {0.35, 0.6, 2.0}, {0.5, 1.0, 0.0}}) {
        TracedWorld const there(grey, mixture, beam(b), 0), back(grey, mixture, beam(a), 0);
        Measured const x = reflected(there.tracer, a, azimuth, 512, seed++);
        Measured const y = reflected(back.tracer, b, azimuth, 512, seed++);
        for (int c = 0; c < 3; ++c) {
            double const deviation = std::hypot(x.deviation[c] / b, y.deviation[c] / a);
            EXPECT_NEAR(x.mean[c] / b, y.mean[c] / a, BOUND * deviation + curvature(a) * x.mean[c] / b)
                << a << ", " << b;
            EXPECT_LT(deviation, 0.03 * x.mean[c] / b);
        }
    }
}
