#include "scene/gltf_limits.h"

#include "core/settings.h"

namespace alpenglow {

GltfLimits gltf_limits(Settings const& settings) {
    return {.largest_scene_file = settings.largest_scene_file,
            .most_json_values = settings.most_json_values,
            .deepest_json = settings.deepest_json,
            .deepest_node = settings.deepest_node,
            .most_instances = settings.most_instances,
            .most_vertices = settings.most_vertices,
            .most_indices = settings.most_indices,
            .largest_picture = settings.largest_picture,
            .most_pixels = settings.most_pixels};
}

} // namespace alpenglow
