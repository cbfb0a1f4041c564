#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace alpenglow {

/// A place where the camera stands close to the ground and wants fine triangles. Metres in the scene's plane.
struct FinePlace {
    double east = 0, north = 0;
    double radius = 600; ///< [m] of the finest tiles; coarser ones around it grade into the rest
};

struct TerrainOptions {
    std::uint32_t seed = 1;
    double side_km = 96;              ///< 4 to 400
    double planet_radius = 6'360'000; ///< [m] vertices follow this curvature
    int resolution = 1024;            ///< cells along a side of the eroded height field, 64 to 4096
    double erosion = 1;               ///< strength: 0 none, 1 alpine; at most 4
    int map_size = 2048;              ///< [texels] along the pictures that clad what is far, 64 to 8192
    std::vector<FinePlace> fine;      ///< empty: the places where the default views stand
    int threads = 0;                  ///< 0: one for each core; the result is the same for any number
};

/// A place that is worth standing at. The file's scene holds the same in its `extras.sites`.
struct TerrainSite {
    std::string name;           ///< "valley", "ridge", "noon"
    double east = 0, north = 0; ///< [m] along the planet's surface from the scene's origin
    double altitude = 0;        ///< [m] of the ground
    double heading = 0;         ///< [degrees] clockwise from north, towards what is worth seeing
};

/// Writes a glTF terrain: `file` (.gltf with a .bin and PNG pictures beside it, or one .glb). Deterministic for its
/// options. Returns its sites. Throws Error(wrong_use) where an option is out of range, Error(bad_input) where a file
/// can't be written.
std::vector<TerrainSite> write_terrain(TerrainOptions const& options, std::filesystem::path const& file);

/// The default scene, made at the first call and cached by its options and the generator's version; a later call only
/// looks.
std::filesystem::path default_terrain(double planet_radius);

} // namespace alpenglow
