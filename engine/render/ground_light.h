#pragma once

#include "render/gpu_scene.h"
#include "scene/view.h"

namespace alpenglow {

/// Mean albedo, 0 to 1, of the ground whose light reaches the air around the camera: that of planet and scene within 30 km
/// near the ground, and the planet's own `ground_albedo` more and more with the altitude, since from high up the air of
/// many places is seen. In steps of 1/128, so that a flight changes the air's tables now and then and not with each
/// metre. `scene` may be null.
glm::vec3 albedo_around(World const& world, GpuScene const* scene);

} // namespace alpenglow
