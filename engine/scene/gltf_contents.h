#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

#include <nlohmann/json.hpp>

/// What the bytes say, against what the JSON says of them. Comes after check_structure and check_accessors.
namespace alpenglow::gltf {

/// All of the following. Throws Error(bad_input) where a code refuses.
void check_contents(nlohmann::json const& json, Document const& document, Report& report);

/// Every number is finite and between the accessor's min and max, which some number takes.
void check_values(nlohmann::json const& json, Document const& document, Report& report);
/// Indices, joints, normals, tangents, colours and weights of every mesh, placed or not.
void check_attribute_values(nlohmann::json const& json, Document const& document, Report& report);
/// Times, rotations and inverse bind matrices.
void check_motion_values(nlohmann::json const& json, Document const& document, Report& report);
/// Media types and headers of every image, used or not; what a material doesn't use is warned of only.
void check_images(nlohmann::json const& json, Document const& document, Report& report);

} // namespace alpenglow::gltf
