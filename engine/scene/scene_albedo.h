#pragma once

#include "scene/scene.h"

#include <vector>

namespace alpenglow {

/// A patch of a scene's ground as seen from straight above.
struct GroundPatch {
    glm::dvec3 position{0}; ///< its middle, world [m]
    double area = 0;        ///< [m^2] of its outline on the map
    glm::vec3 albedo{0};    ///< share of the light from above that leaves again: base colours by their outlines, less between slopes; 0 to 1
};

/// Patches of a scene's ground on a grid of GROUND_PATCHES by as many over the outline of its bounds. What lies under
/// the planet's surface does not count; patches without ground are left out. Where surfaces lie above each other they
/// count by their mean, once.
inline constexpr int GROUND_PATCHES = 32;
std::vector<GroundPatch> ground_patches(Scene const& scene, glm::dmat4 const& world_from_scene, double planet_radius);

} // namespace alpenglow
