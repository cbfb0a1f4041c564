#include "support/components.h"
#include "support/traced_world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

/// The white furnace: where nothing absorbs and the same light comes in from all sides, the same light is everywhere.
using namespace alpenglow;
using namespace alpenglow::test;

namespace {

Planet white_earth() {
    Planet planet = make_earth();
    planet.look = GroundLook::uniform;
    planet.ground_albedo = glm::dvec3(1);
    AirComponent& aerosol = planet.air.at("aerosol");
    aerosol.scattering = aerosol.extinction();
    aerosol.absorption = planet.air.at("ozone").absorption = glm::dvec3(0);
    return planet;
}

Planet dense_white_earth() {
    Planet planet = white_earth();
    planet.air.at("rayleigh") = rayleigh_component({4e-5, 1e-4, 2e-4}, 12000);
    return planet;
}

LightSource const FURNACE = {.irradiance = glm::dvec3(0), .background = glm::dvec3(1)};

/// Radiance of rays from the ground, the air and space, up, down and along the horizon.
std::vector<Measured> radiances(Planet const& planet, int paths) {
    TracedWorld const world(planet, FURNACE, 0);
    std::vector<Measured> all;
    std::uint64_t seed = 1;
    for (double const h : {0.0, 3e3, 4e5})
        for (double const elevation : {-90.0, -30.0, -19.7, -1.0, 0.5, 20.0, 90.0}) {
            double const e = glm::radians(elevation);
            glm::dvec3 const origin(0, 0, planet.radius + h), direction(std::cos(e), 0, std::sin(e));
            all.push_back(measure(world.tracer, origin, direction, paths, seed++));
        }
    return all;
}

void expect_one(Planet const& planet, int paths) {
    ChiSquare together;
    for (Measured const& m : radiances(planet, paths)) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(m.mean[c], 1, BOUND * m.deviation[c] + 1e-6);
        EXPECT_LT(m.deviation.z, 0.03);
        together.add(m.mean.z - 1, m.deviation.z * m.deviation.z + 1e-12);
    }
    EXPECT_GT(together.tail(), 1e-4);
}

} // namespace

TEST(ReferenceFurnace, clear_air_over_white_ground) { expect_one(white_earth(), 64); }

TEST(ReferenceFurnace, dense_air_over_white_ground) { expect_one(dense_white_earth(), 64); }

TEST(ReferenceFurnace, a_percent_of_absorption_is_seen) {
    Planet grey = white_earth();
    AirComponent& rayleigh = grey.air.at("rayleigh");
    rayleigh.absorption = 0.01 * rayleigh.scattering;
    ChiSquare together;
    for (Measured const& m : radiances(grey, 64)) together.add(m.mean.z - 1, m.deviation.z * m.deviation.z + 1e-12);
    EXPECT_LT(together.tail(), 1e-6);
}
