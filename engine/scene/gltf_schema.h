#pragma once

#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

namespace alpenglow::gltf {

/// Checks types, ranges, enumerations and every reference of the JSON before the parser sees it: the parser takes a
/// value of a wrong type for a missing one. Whole numbers written as 3.0 become integers. Throws Error(bad_input).
void check_schema(nlohmann::json& json, Report& report);

/// glTF 2.x only, as asset.version and asset.minVersion say. Comes first: other versions have other schemas. Throws
/// Error(bad_input).
void check_version(nlohmann::json const& json, Report const& report);

/// Refuses required extensions that are not supported, by name, and warns of those that are only used. Throws
/// Error(bad_input).
void check_extensions(nlohmann::json const& json, Report& report);

} // namespace alpenglow::gltf
