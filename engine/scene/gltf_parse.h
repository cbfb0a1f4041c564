#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_source.h"

namespace alpenglow::gltf {

/// JSON that check_schema has passed, as plain data, through tinygltf: the one place that knows it. tinygltf gets no
/// buffer, no picture and no file to open. `scene_index`: the scene that is shown, the file's default unless given.
/// Throws Error(bad_input).
Document parse_document(nlohmann::json const& json, std::optional<int> scene_index, Report& report);

} // namespace alpenglow::gltf
