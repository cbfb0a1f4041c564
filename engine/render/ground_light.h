#pragma once

#include "scene/scene_albedo.h"
#include "scene/view.h"

#include <span>

namespace alpenglow {

/// Mean albedo, 0 to 1, of the ground that lights the air around the camera: as an eye some kilometres above the camera
/// sees the ground below, each patch by its solid angle. So it gives way to the planet's `ground_albedo` with the
/// altitude and away from the scene. `patches`: of a scene that stands there.
glm::vec3 albedo_around(World const& world, std::span<GroundPatch const> patches, glm::dmat4 const& world_from_scene);

} // namespace alpenglow
