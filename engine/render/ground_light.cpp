#include "render/ground_light.h"

#include "surface/planet_look.glsl"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double SCATTERING_REACH = 3e4; ///< [m] along which light near the ground is scattered: a few heights of the air

glm::vec3 planet_albedo(Planet const& planet, glm::dvec3 const& up, double reach) {
    if (planet.look == GroundLook::uniform) return glm::vec3(planet.ground_albedo);
    // A pixel as wide as the disc is the mean of what lies in it.
    glm::vec3 const in_period(glm::mod(up * planet.radius, glm::dvec3(GROUND_PERIOD)));
    float const footprint = static_cast<float>(2 * reach / planet.radius);
    return shader::planet_look(glm::vec3(up), in_period, footprint, static_cast<float>(planet.radius)).albedo;
}

/// The share of a disc of the radius `reach` that another of the radius `radius` covers, whose centre is `apart` from its.
double covered_share(double reach, double radius, double apart) {
    double const overlap = std::clamp((radius + reach - apart) / (2 * std::min(radius, reach)), 0.0, 1.0);
    return overlap * std::min(1.0, radius * radius / (reach * reach));
}

} // namespace

glm::vec3 albedo_around(World const& world, GpuScene const* scene) {
    glm::dvec3 const up = glm::normalize(world.camera.position);
    double const reach = SCATTERING_REACH + std::max(glm::length(world.camera.position) - world.planet.radius, 0.0);
    glm::vec3 albedo = planet_albedo(world.planet, up, reach);
    if (scene && !scene->bounds().empty()) {
        glm::dvec3 const centre(scene->world_from_scene() * glm::dvec4(scene->bounds().centre(), 1));
        glm::dvec3 const size = (scene->bounds().highest - scene->bounds().lowest) * glm::length(scene->world_from_scene()[0]);
        double const apart = world.planet.radius * glm::length(glm::normalize(centre) - up);
        double const share = covered_share(reach, std::max(0.5 * std::sqrt(size.x * size.z), 1e-3), apart);
        albedo = glm::mix(albedo, scene->albedo(), static_cast<float>(share));
    }
    return glm::round(albedo * 128.0f) / 128.0f;
}

} // namespace alpenglow
