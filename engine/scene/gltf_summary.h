#pragma once

#include "scene/gltf.h"
#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

namespace alpenglow::gltf {

/// What the JSON that check_schema has passed says beyond what is drawn, and a warning for each kind of thing that is
/// left out: animations, lights. Throws Error(bad_input) on a light that is none.
GltfSummary summarize(nlohmann::json const& json, Report& report);

} // namespace alpenglow::gltf
