#pragma once

#include "scene/gltf.h"
#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

namespace alpenglow::gltf {

/// Fills in what the JSON that check_schema has passed says beyond what is drawn, and gives a warning for each kind of thing that is
/// left out: animations, lights.
void summarize(nlohmann::json const& json, GltfSummary& summary, Report& report);

} // namespace alpenglow::gltf
