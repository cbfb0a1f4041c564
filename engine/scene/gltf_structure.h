#pragma once

#include "scene/gltf_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

/// What the format asks of a file's JSON beyond types, ranges and references, which check_schema has passed: what goes
/// together and what doesn't. Each function says what it finds; nothing here looks into buffers.
namespace alpenglow::gltf {

/// All of the following. Throws Error(bad_input) where a code refuses.
void check_structure(nlohmann::json const& json, Report& report);

void check_extension_objects(nlohmann::json const& json, Report& report);
void check_extension_values(nlohmann::json const& json, Report& report);
void check_views_and_images(nlohmann::json const& json, Report& report);
void check_meshes(nlohmann::json const& json, Report& report);
void check_nodes_and_cameras(nlohmann::json const& json, Report& report);
void check_skins(nlohmann::json const& json, Report& report);
void check_animations(nlohmann::json const& json, Report& report);

/// The member `key` of an object; null where there is none.
inline nlohmann::json const& member(nlohmann::json const& object, char const* key) {
    static nlohmann::json const none;
    auto const found = object.find(key);
    return found == object.end() ? none : *found;
}

/// What `index` points to in one of the document's arrays.
inline nlohmann::json const& referred(nlohmann::json const& json, char const* array, nlohmann::json const& index) {
    return json[array][index.get<std::size_t>()];
}

/// Calls `visit(element, pointer)` for each element of an array, which may be missing.
template <class Visit>
void for_each(nlohmann::json const& object, char const* key, std::string const& pointer, Visit const& visit) {
    nlohmann::json const& array = member(object, key);
    for (std::size_t i = 0; i < array.size(); ++i) visit(array[i], fmt::format("{}/{}/{}", pointer, key, i));
}

/// Whether the accessor's view, if it has one, has a byteStride.
bool has_stride(nlohmann::json const& json, nlohmann::json const& accessor);
/// "VEC3 5126", as messages and tables of formats write it; with " normalized" where it is.
std::string format_of(nlohmann::json const& accessor);

} // namespace alpenglow::gltf
