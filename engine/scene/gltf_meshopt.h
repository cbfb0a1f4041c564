#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

namespace alpenglow::gltf {

/// EXT_meshopt_compression: puts the decompressed bytes of each compressed view into a new buffer, and points the view
/// there. Throws Error(bad_input).
void decompress_views(Document& document, nlohmann::json const& json, Report const& report);

/// A buffer that only stands for what compressed views hold, and has no bytes of its own.
bool is_meshopt_fallback(nlohmann::json const& buffer);

} // namespace alpenglow::gltf
