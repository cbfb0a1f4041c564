#pragma once

namespace alpenglow {

struct Settings;

/// What a glTF file may ask for. Each is the setting of the same name.
struct GltfLimits {
    int largest_scene_file = 4096;    ///< [MiB], of the file and of each that it names; a .glb can't be larger
    int most_json_values = 8'000'000; ///< about 0.5 GiB once parsed
    int deepest_json = 100;           ///< levels
    int deepest_node = 500;           ///< levels
    int most_instances = 1'000'000;   ///< placed meshes
    int most_vertices = 16 << 20;     ///< in all; 1.1 GiB
    int most_indices = 192 << 20;     ///< in all; 0.8 GiB
    int largest_picture = 16384;      ///< [texels] side of a picture before it is scaled down
    int most_pixels = 128;            ///< [MiB texels] of a picture; four times as many bytes once decoded
};

GltfLimits gltf_limits(Settings const& settings);

} // namespace alpenglow
