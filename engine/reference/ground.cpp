#include "reference/ground.h"

#include "reference/planet_body.h"
#include "reference/surface_scattering.h"
#include "reference/terrain_mesh.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

/// How far points stand over the planet's body, in radii: 1.5 micrometres on the Earth, 1500 roundings of a coordinate.
constexpr double PLANET_OFFSET = 0x1p-42;
/// As the renderer widens footprints at most (shaders/passes/planet.frag).
constexpr double LEAST_FACING = 0.02;

} // namespace

Ground::Ground(Planet const& planet, Scene const* scene, Placement const& placement) : planet_(planet) {
    if (scene) terrain_ = std::make_unique<TerrainMesh>(*scene, placement, planet.radius);
    if (terrain_ && terrain_->empty()) terrain_.reset();
}

Ground::~Ground() = default;
Ground::Ground(Ground&&) noexcept = default;

std::optional<GroundPoint> Ground::first_hit(glm::dvec3 const& origin, glm::dvec3 const& direction, double longest,
                                             double pixel_angle) const {
    auto const planet = distance_to_planet(origin, direction);
    bool const body = planet && *planet < longest;
    if (terrain_) {
        Sides const sides = pixel_angle > 0 ? Sides::seen : Sides::both;
        auto const hit = terrain_->first_hit(origin, direction, body ? *planet : longest, sides);
        if (hit) return hit;
    }
    if (!body) return {};
    return planet_point(origin, direction, *planet, pixel_angle);
}

bool Ground::sees_out(glm::dvec3 const& origin, glm::dvec3 const& direction) const {
    return !distance_to_planet(origin, direction) && !(terrain_ && terrain_->occludes(origin, direction));
}

/// From factors that don't cancel: the height over the sphere, and the closest approach to the centre.
std::optional<double> Ground::distance_to_planet(glm::dvec3 const& origin, glm::dvec3 const& direction) const {
    double const radius = planet_.radius, along = glm::dot(origin, direction);
    if (along >= 0) return {};
    double const closest = glm::length(origin - along * direction);
    if (closest >= radius) return {};
    double const from_centre = glm::length(origin), height = from_centre - radius;
    double const half_chord = std::sqrt((radius - closest) * (radius + closest));
    return std::max(height * (from_centre + radius) / (half_chord - along), 0.0);
}

GroundPoint Ground::planet_point(glm::dvec3 const& origin, glm::dvec3 const& direction, double distance,
                                 double pixel_angle) const {
    glm::dvec3 const reached = origin + distance * direction, unit = glm::normalize(reached);
    GroundPoint point;
    point.distance = distance;
    point.position = unit * (planet_.radius * (1 + PLANET_OFFSET));
    point.facing = point.shading = unit;
    if (!(pixel_angle > 0) || planet_.look == GroundLook::uniform) {
        point.surface = make_ground_surface(planet_.ground_albedo, 0.0, 1.0, 0.0);
        return point;
    }
    double const facing = std::max(glm::dot(unit, -direction), LEAST_FACING);
    BodyLook const look = look_of_body(planet_, reached, pixel_angle * distance / std::sqrt(facing));
    point.surface = make_ground_surface(look.albedo, 0.0, look.roughness);
    return point;
}

} // namespace alpenglow
