#include "scene/scene.h"

namespace alpenglow {

std::size_t triangle_count(Scene const& scene) {
    std::size_t count = 0;
    for (Instance const& instance : scene.instances) count += scene.meshes[instance.mesh].indices.size() / 3;
    return count;
}

Box scene_bounds(Scene const& scene) {
    Box bounds;
    for (Instance const& instance : scene.instances) {
        for (MeshPart const& part : scene.meshes[instance.mesh].parts) {
            for (int corner = 0; corner < 8; ++corner) {
                glm::dvec3 const& low = part.bounds.lowest;
                glm::dvec3 const& high = part.bounds.highest;
                glm::dvec4 const point(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                       corner & 4 ? high.z : low.z, 1);
                bounds.include(glm::dvec3(instance.scene_from_mesh * point));
            }
        }
    }
    return bounds;
}

} // namespace alpenglow
