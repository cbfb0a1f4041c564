#pragma once

#include "scene/scene_albedo.h"
#include "scene/view.h"

#include <span>

namespace alpenglow {

/// The ground that lights the air around the camera.
struct GroundAround {
    glm::vec3 albedo{0}; ///< 0 to 1
    float altitude = 0;  ///< [m] above the planet's radius

    bool operator==(GroundAround const&) const = default;
};

/// The planet alone: its `ground_albedo`, at altitude 0.
GroundAround planet_ground(Planet const& planet);

/// The mean over what an eye some kilometres above `place` [m], world, sees of the ground below, each patch by its solid
/// angle and the rest as the planet's. So it gives way to the planet's with the altitude and away from the scene.
/// `patches`: of the scene that stands there.
GroundAround ground_around(Planet const& planet, glm::dvec3 const& place, std::span<GroundPatch const> patches);

} // namespace alpenglow
