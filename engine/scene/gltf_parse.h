#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_source.h"

namespace alpenglow::gltf {

/// JSON that check_schema has passed, as plain data, through tinygltf: the one place that knows it. tinygltf gets no
/// buffer, no picture and no file to open. Throws Error(bad_input).
Document parse_document(nlohmann::json const& json, Report& report);

} // namespace alpenglow::gltf
