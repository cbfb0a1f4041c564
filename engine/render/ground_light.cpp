#include "render/ground_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

/// [m] of the eye above the place: below this lies half of Earth's air. Anything from 3 to 15 km serves about as well.
constexpr double EYE_ABOVE = 5e3;

/// [sr] of a sphere of that radius, seen from a height over it [m].
double solid_angle_of_planet(double radius, double height) {
    return 2 * std::numbers::pi * (1 - std::sqrt(height * (2 * radius + height)) / (radius + height));
}

/// [sr]
double solid_angle(GroundPatch const& patch, glm::dvec3 const& eye) {
    glm::dvec3 const to_eye = eye - patch.position;
    double const distance = glm::length(to_eye);
    return std::max(glm::dot(to_eye, glm::normalize(patch.position)), 0.0) * patch.area / (distance * distance * distance);
}

/// [m] Above the planet. The eye is not so near that a patch is more than a spot.
double eye_height(Planet const& planet, glm::dvec3 const& place, std::span<GroundPatch const> patches) {
    double widest = 0;
    for (GroundPatch const& patch : patches) widest = std::max(widest, std::sqrt(patch.area));
    return std::max(glm::length(place) - planet.radius, 0.0) + std::max(EYE_ABOVE, widest);
}

} // namespace

GroundAround planet_ground(Planet const& planet) { return {glm::vec3(planet.ground_albedo), 0}; }

GroundAround ground_around(Planet const& planet, glm::dvec3 const& place, std::span<GroundPatch const> patches) {
    double const radius = planet.radius, height = eye_height(planet, place, patches);
    glm::dvec3 const eye = glm::normalize(place) * (radius + height);
    double share = 0, altitude = 0;
    glm::dvec3 albedo(0);
    for (GroundPatch const& patch : patches) {
        double const weight = solid_angle(patch, eye) / solid_angle_of_planet(radius, height);
        share += weight;
        albedo += weight * glm::dvec3(patch.albedo);
        altitude += weight * std::max(glm::length(patch.position) - radius, 0.0);
    }
    double const rest = std::max(1 - share, 0.0), whole = share + rest;
    altitude = std::min(altitude / whole, planet.air.top_altitude);
    return {glm::vec3((albedo + rest * planet.ground_albedo) / whole), static_cast<float>(altitude)};
}

} // namespace alpenglow
