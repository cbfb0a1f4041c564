#include "render/ground_light.h"

#include "surface/planet_look.glsl"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double REACH = 3e4; ///< [m] along which light near the ground is scattered: a few heights of the air

glm::vec3 planet_albedo(Planet const& planet, glm::dvec3 const& up) {
    if (planet.look == GroundLook::uniform) return glm::vec3(planet.ground_albedo);
    // A pixel as wide as the disc is the mean of what lies in it.
    glm::vec3 const in_period(glm::mod(up * planet.radius, glm::dvec3(GROUND_PERIOD)));
    float const footprint = static_cast<float>(2 * REACH / planet.radius);
    return shader::planet_look(glm::vec3(up), in_period, footprint, static_cast<float>(planet.radius)).albedo;
}

/// The share of the disc that another of the radius `radius` covers, whose centre is `apart` [m] from its.
double covered_share(double radius, double apart) {
    double const overlap = std::clamp((radius + REACH - apart) / (2 * std::min(radius, REACH)), 0.0, 1.0);
    return overlap * std::min(1.0, radius * radius / (REACH * REACH));
}

glm::vec3 albedo_below(World const& world, GpuScene const* scene, glm::dvec3 const& up) {
    glm::vec3 const albedo = planet_albedo(world.planet, up);
    if (!scene || scene->bounds().empty()) return albedo;
    glm::dvec3 const centre(scene->world_from_scene() * glm::dvec4(scene->bounds().centre(), 1));
    glm::dvec3 const size = (scene->bounds().highest - scene->bounds().lowest) * glm::length(scene->world_from_scene()[0]);
    double const apart = world.planet.radius * glm::length(glm::normalize(centre) - up);
    double const share = covered_share(std::max(0.5 * std::sqrt(size.x * size.z), 1e-3), apart);
    return glm::mix(albedo, scene->albedo(), static_cast<float>(share));
}

} // namespace

glm::vec3 albedo_around(World const& world, GpuScene const* scene) {
    double const distance = glm::length(world.camera.position);
    double const altitude = std::max(distance - world.planet.radius, 0.0);
    glm::vec3 const below = albedo_below(world, scene, world.camera.position / distance);
    glm::vec3 const albedo = glm::mix(glm::vec3(world.planet.ground_albedo), below, static_cast<float>(REACH / (REACH + altitude)));
    return glm::round(albedo * 128.0f) / 128.0f;
}

} // namespace alpenglow
