#pragma once

#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <vector>

namespace alpenglow::gltf {

/// A glTF file taken apart: its JSON and, for a .glb, the binary chunk.
struct Source {
    nlohmann::json json; ///< an object
    bool binary = false;
    std::vector<std::byte> chunk;
};

/// Reads the file, tells .glb from .gltf by content, and checks the container, the JSON's size and its depth.
/// Throws Error(bad_input).
Source read_source(Report& report);

/// A file that is no larger than the limit. Throws Error(bad_input); with a pointer, as something that the scene names.
std::vector<std::byte> read_limited(std::filesystem::path const& path, std::string const& pointer,
                                    Report const& report);

} // namespace alpenglow::gltf
