#pragma once

#include "scene/gltf.h"

namespace alpenglow {

/// What a person asks of a scene before flying over it, as lines.
std::string inspection_text(Scene const& scene, GltfSummary const& summary);
/// The same as JSON: lengths in metres, memory in bytes.
std::string inspection_json(Scene const& scene, GltfSummary const& summary);

} // namespace alpenglow
