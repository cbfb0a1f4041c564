#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace alpenglow {

/// A place where the camera stands close to the ground and wants fine triangles. Metres in the scene's plane.
struct FinePlace {
    double east = 0, north = 0;
    double radius = 600; ///< [m] of the finest tiles; coarser ones around it grade into the rest
};

struct TerrainOptions {
    std::uint32_t seed = 1;
    double side_km = 96;
    double planet_radius = 6'360'000; ///< [m] vertices follow this curvature
    int resolution = 1024;            ///< cells along a side of the eroded height field
    double erosion = 1;               ///< strength: 0 none, 1 alpine
    std::vector<FinePlace> fine;      ///< empty: the places where the default views stand
};

/// Writes a glTF terrain: `file` (.gltf with a .bin and PNG pictures beside it, or one .glb). Deterministic for its options.
void write_terrain(TerrainOptions const& options, std::filesystem::path const& file);

/// The default scene, made at the first call and cached by its options and the generator's version; a later call only looks.
std::filesystem::path default_terrain(double planet_radius);

} // namespace alpenglow
