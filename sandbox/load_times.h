#pragma once

#include "gpu/device.h"
#include "scene/view.h"

#include <cstddef>
#include <filesystem>
#include <functional>

namespace alpenglow {

/// How long a scene takes to load: medians over rounds, each of which takes every step once from its beginning.
struct LoadTimes {
    struct Step {
        double wall_ms = 0;
        double cpu_ms = 0; ///< of all threads; moves less where other programs want the cores
    };
    /// What no importer can do without: reads the files, parses the JSON, unpacks what is compressed and decodes all
    /// pictures, on all cores.
    Step read_and_decode;
    Step load;            ///< load_gltf
    Step load_and_upload; ///< load_gltf, and everything brought to the device
    std::size_t triangles = 0, pictures = 0;
};

/// Rounds before the measured ones: files come into the system's cache.
inline constexpr int LOAD_WARM_UP_ROUNDS = 1;

/// `view` gives the scene's index, limits and largest texture. `before_round` is called ahead of each round. Throws
/// Error.
LoadTimes time_loading(Device const& device, std::filesystem::path const& file, View const& view, int rounds,
                       std::function<void()> const& before_round);

} // namespace alpenglow
