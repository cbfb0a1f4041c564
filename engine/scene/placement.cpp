#include "scene/scene.h"

namespace alpenglow {

glm::dmat4 world_from_scene(Placement const& placement, double planet_radius) {
    Geodetic const& anchor = placement.anchor;
    glm::dmat3 const axes = placement.scale * world_from_gltf_axes(anchor.latitude, anchor.longitude, placement.yaw);
    glm::dmat4 world_from_scene(axes);
    world_from_scene[3] = glm::dvec4(world_from_geodetic(anchor, planet_radius), 1);
    return world_from_scene;
}

} // namespace alpenglow
