#pragma once

namespace alpenglow {

struct Settings;

/// What a glTF file may ask for. Each is the setting of the same name.
struct GltfLimits {
    int largest_scene_file = 4096;    ///< [MiB], of the file, and of all that it names or unpacks; a .glb can't be larger
    int most_json_values = 8'000'000; ///< about 0.5 GiB once parsed
    int most_entries = 1'000'000;     ///< nodes, meshes, primitives, accessors, …, of each; about 1 GiB
    int most_materials = 65536;       ///< 0.2 GiB
    int deepest_json = 100;           ///< levels
    int deepest_node = 500;           ///< levels
    int most_instances = 1'000'000;   ///< placed meshes
    int most_vertices = 16 << 20;     ///< in all, and once more where they are moved or bent; 1.1 GiB
    int most_indices = 192 << 20;     ///< in all; 0.8 GiB
    int largest_picture = 16384;      ///< [texels] side of a picture before it is scaled down
    int most_triangles = 64 << 20;    ///< that are drawn: those of a mesh count once for each instance
    int most_pixels = 128;            ///< [Mi texels] of a picture; four times as many bytes once decoded, or eight
    int most_picture_memory = 4096;   ///< [MiB] of all pictures that materials use, scaled down, without mipmaps
};

GltfLimits gltf_limits(Settings const& settings);

} // namespace alpenglow
