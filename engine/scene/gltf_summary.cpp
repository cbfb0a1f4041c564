#include "scene/gltf_summary.h"

#include "scene/gltf_json.h"

#include <fmt/format.h>

namespace alpenglow::gltf {

namespace {

std::string light_text(JsonObject const& light) {
    std::string const kind = light.text("type", "");
    return fmt::format("{} {} of {} {}", printable(kind), printable(light.text("name", "light")), light.number("intensity", 1, 0),
                       kind == "directional" ? "lx" : "cd");
}

std::vector<std::string> extension_names(nlohmann::json const& json) {
    nlohmann::json const none = nlohmann::json::array();
    nlohmann::json const required = json.value("extensionsRequired", none);
    std::vector<std::string> names;
    for (std::string const name : json.value("extensionsUsed", none)) {
        bool const needed = std::find(required.begin(), required.end(), name) != required.end();
        names.push_back(printable(name) + (needed ? " (required)" : ""));
    }
    return names;
}

} // namespace

void summarize(nlohmann::json const& json, GltfSummary& summary, Report& report) {
    JsonObject const root(json, "", report);
    for (JsonObject const& scene : root.objects("scenes")) summary.scenes.push_back(printable(scene.text("name", "")));
    summary.extensions = extension_names(json);
    summary.animations = root.objects("animations").size();
    summary.skins = root.objects("skins").size();
    if (auto const lights = root.extension("KHR_lights_punctual"))
        for (JsonObject const& light : lights->objects("lights")) summary.lights.push_back(light_text(light));
    if (summary.animations > 0) report.warn("animations are ignored: everything stands in its rest pose");
    if (!summary.lights.empty())
        report.warn("lights of the file (KHR_lights_punctual) are left out: the sun is the only light");
}

} // namespace alpenglow::gltf
