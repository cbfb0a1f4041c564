#include "scene/gltf_entries.h"

#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

std::size_t count_primitives(Json const& meshes) {
    std::size_t count = 0;
    for (Json const& mesh : meshes) {
        if (auto const primitives = mesh.find("primitives"); primitives != mesh.end()) count += primitives->size();
    }
    return count;
}

} // namespace

void check_entries(Json const& json, Report const& report) {
    auto const check = [&](std::size_t count, int most, std::string_view setting, std::string const& pointer,
                           char const* what) {
        if (count > static_cast<std::size_t>(most))
            report.refuse_beyond(setting, most, pointer, fmt::format("holds {} {}", count, what));
    };
    GltfLimits const& limits = report.limits();
    for (auto const& [key, value] : json.items()) {
        if (!value.is_array()) continue;
        std::string const pointer = fmt::format("/{}", printable(key));
        check(value.size(), limits.most_entries, "most_entries", pointer, "entries");
        if (key == "materials")
            check(value.size(), limits.most_materials, "most_materials", pointer, "materials");
        if (key == "meshes")
            check(count_primitives(value), limits.most_entries, "most_entries", pointer, "primitives");
    }
}

} // namespace alpenglow::gltf
