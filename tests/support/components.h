#pragma once

#include "scene/planet.h"

/// Constituents of air for tests.
namespace alpenglow::test {

inline AirComponent rayleigh_component(glm::dvec3 const& scattering, double scale_height) {
    return {.name = "rayleigh",
            .scattering = scattering,
            .phase = {.kind = Phase::Kind::rayleigh},
            .profile = ExponentialProfile{scale_height}};
}

inline AirComponent aerosol_component(glm::dvec3 const& scattering, glm::dvec3 const& absorption, double scale_height,
                                      double g) {
    return {.name = "aerosol",
            .scattering = scattering,
            .absorption = absorption,
            .phase = {.kind = Phase::Kind::cornette_shanks, .g = g},
            .profile = ExponentialProfile{scale_height}};
}

/// Sakmary's fictional planet, his table 5.4; ozone and all else as Earth's.
inline Planet dense_planet() {
    Planet planet = make_earth();
    planet.air.at("rayleigh") = rayleigh_component({0.149e-3, 0.142e-3, 0.051e-3}, 18416);
    planet.air.at("aerosol") =
        aerosol_component({0.046e-3, 0.047e-3, 0.057e-3}, {0.036e-3, 0.024e-3, 0.001e-3}, 13143, 0.8);
    return planet;
}

/// Fernandez Arenas' hazy Earth.
inline Planet hazy_planet() {
    Planet planet = make_earth();
    planet.air.at("aerosol") = aerosol_component(glm::dvec3(2e-5), glm::dvec3(2e-5 / 9), 1200, 0.76);
    return planet;
}

/// One of each kind of profile, and of phase but isotropic.
inline Planet motley_planet() {
    Planet planet = make_earth();
    planet.air.components = {
        {.name = "shell",
         .scattering = glm::dvec3(4e-6, 5e-6, 6e-6),
         .absorption = glm::dvec3(1e-6),
         .phase = {.kind = Phase::Kind::double_henyey_greenstein, .g = 0.8, .second_g = -0.4, .second_weight = 0.3},
         .profile = shell_profile(18000, 21000)},
        rayleigh_component({5.8e-6, 13.5e-6, 33e-6}, 8000),
        {.name = "mist",
         .scattering = glm::dvec3(3e-5),
         .absorption = glm::dvec3(1e-6, 0, 0),
         .phase = {.kind = Phase::Kind::droplets, .diameter = 8e-6},
         .profile = LinearProfile{{{0, 0.7}, {500, 1}, {1500, 0.2}, {1500, 0.6}, {2500, 0.1}}}},
        {.name = "ozone", .absorption = glm::dvec3(0.6e-6, 1.9e-6, 0.1e-6), .profile = tent_profile(25000, 15000)},
        {.name = "dust",
         .scattering = glm::dvec3(4e-6, 3e-6, 2e-6),
         .phase = {.kind = Phase::Kind::henyey_greenstein, .g = 0.6},
         .profile = ExponentialProfile{1500}},
        aerosol_component(glm::dvec3(2e-6), glm::dvec3(2e-7), 1200, 0.8)};
    return planet;
}

} // namespace alpenglow::test
