#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

namespace alpenglow::gltf {

/// KHR_draco_mesh_compression: decodes each compressed primitive and points its accessors to the decoded bytes; its
/// triangles become a list. The views must be checked before. Throws Error(bad_input).
void decompress_primitives(Document& document, Report const& report);

} // namespace alpenglow::gltf
