#pragma once

#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

namespace alpenglow::gltf {

/// Whether the document's arrays are within the limits: an empty object is three bytes in a file, and a thousand times
/// as many once it is a material. Throws Error(bad_input).
void check_entries(nlohmann::json const& json, Report const& report);

} // namespace alpenglow::gltf
