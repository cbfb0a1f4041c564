#include "render/ground_light.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstdio>
#include <numbers>

namespace alpenglow {

namespace {

/// [m] The eye stands so much above the camera: 
double REACH = std::getenv("REACH") ? std::atof(std::getenv("REACH")) : 8e3;

/// Solid angle [sr] of a sphere of that radius, seen from a height over it [m].
double solid_angle_of_planet(double radius, double height) {
    return 2 * std::numbers::pi * (1 - std::sqrt(height * (2 * radius + height)) / (radius + height));
}

} // namespace

glm::vec3 albedo_around(World const& world, std::span<GroundPatch const> patches, glm::dmat4 const& world_from_scene) {
    glm::vec3 const mean(world.planet.ground_albedo);
    double const scale = glm::length(world_from_scene[0]), distance = glm::length(world.camera.position);
    double widest = 0; // [m] no patch may be wider than what the eye sees best
    for (GroundPatch const& patch : patches) widest = std::max(widest, scale * std::sqrt(patch.area));
    double const height = std::max({distance - world.planet.radius, 0.0}) + std::max(REACH, widest);
    glm::dvec3 const eye = world.camera.position / distance * (world.planet.radius + height);
    double const whole = solid_angle_of_planet(world.planet.radius, height);
    double share = 0;
    glm::dvec3 sum(0);
    for (GroundPatch const& patch : patches) {
        glm::dvec3 const place(world_from_scene * glm::dvec4(patch.centre, 1)), to_eye = eye - place;
        double const across = glm::dot(to_eye, glm::normalize(place)), away = glm::length(to_eye);
        double const weight = std::max(across, 0.0) * scale * scale * patch.area / (away * away * away * whole);
        share += weight;
        sum += weight * glm::dvec3(patch.albedo);
    }
    glm::vec3 const a(share > 1 ? sum / share : sum + (1 - share) * glm::dvec3(mean));
    std::fprintf(stderr, "share %f albedo %f %f %f of %f %f %f\n", share, a.x, a.y, a.z, sum.x/share, sum.y/share, sum.z/share);
    return a;
}

} // namespace alpenglow
