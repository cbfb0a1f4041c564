#pragma once

#include "scene/json_reader.h"
#include "scene/view.h"

#include <vector>

/// What view and flight files have in common.
namespace alpenglow {

CameraPlace read_camera(json::Value const& value);
SunPlace read_sun_place(json::Value const& value);

/// Keys that a view and a flight share: planet, scene, sun, every setting, and those that people and editors write.
std::vector<std::string_view> base_view_keys();
/// Fills in everything of `base_view_keys`. `file` gives the name, and the folder that paths in it start from.
View read_base_view(json::Object const& object, std::filesystem::path const& file);

} // namespace alpenglow
