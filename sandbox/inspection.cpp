#include "sandbox/inspection.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

struct Counts {
    std::size_t vertices = 0, mesh_triangles = 0;
    std::size_t geometry_bytes = 0, picture_bytes = 0;
};

Counts counts_of(Scene const& scene) {
    Counts counts;
    for (Mesh const& mesh : scene.meshes) {
        counts.vertices += mesh.vertices.size();
        counts.mesh_triangles += mesh.indices.size() / 3;
        counts.geometry_bytes += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
    }
    // A picture with its mipmaps takes a third more.
    for (Picture const& picture : scene.pictures) counts.picture_bytes += picture.rgba.size() * 4 / 3;
    return counts;
}

std::string mebibytes(std::size_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20)); }

std::string size_text(Box const& box) {
    if (box.empty()) return "nothing";
    glm::dvec3 const size = box.highest - box.lowest;
    return fmt::format("{:.6g} x {:.6g} x {:.6g} m (east, up, north), from {:.6g}, {:.6g}, {:.6g}", size.x, size.y,
                       size.z, box.lowest.x, box.lowest.y, 0 - box.highest.z);
}

Json vector_json(glm::dvec3 const& v) { return {v.x, v.y, v.z}; }

/// A line for each thing of a list; none for an empty one.
std::string list_text(char const* what, std::vector<std::string> const& things) {
    std::string text;
    for (std::string const& thing : things) text += fmt::format("{:<12}{}\n", text.empty() ? what : "", thing);
    return text;
}

std::vector<std::string> camera_texts(Scene const& scene) {
    std::vector<std::string> texts;
    for (SceneCamera const& camera : scene.cameras)
        texts.push_back(fmt::format("{}, {:.3g} degrees high", camera.name, glm::degrees(camera.vertical_fov)));
    return texts;
}

Json warnings_json(GltfSummary const& summary) {
    Json list = Json::array();
    for (GltfDiagnostic const& warning : summary.warnings)
        list.push_back({{"pointer", warning.pointer}, {"code", warning.code}, {"message", warning.message}});
    return list;
}

std::vector<std::string> scene_texts(GltfSummary const& summary) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < summary.scenes.size(); ++i) {
        bool const shown = static_cast<int>(i) == summary.shown_scene;
        texts.push_back(fmt::format("{} {}{}", i, summary.scenes[i], shown ? " (shown)" : ""));
    }
    return texts;
}

} // namespace

std::string inspection_text(Scene const& scene, GltfSummary const& summary) {
    Counts const counts = counts_of(scene);
    std::string text = fmt::format("{:<12}{} drawn by {} instances of {} meshes ({} stored, {} vertices)\n",
                                   "triangles", triangle_count(scene), scene.instances.size(), scene.meshes.size(),
                                   counts.mesh_triangles, counts.vertices);
    text += fmt::format("{:<12}{}\n", "extent", size_text(scene.bounds));
    text += fmt::format("{:<12}{}, {} textures\n", "materials", scene.materials.size(), scene.pictures.size());
    text += fmt::format("{:<12}{} geometry, {} textures\n", "memory", mebibytes(counts.geometry_bytes),
                        mebibytes(counts.picture_bytes));
    if (summary.scenes.size() > 1) text += list_text("scenes", scene_texts(summary));
    text += list_text("cameras", camera_texts(scene));
    text += list_text("lights", summary.lights);
    text += list_text("extensions", summary.extensions);
    text += list_text("warnings", warning_lines(summary));
    return text;
}

std::string inspection_json(Scene const& scene, GltfSummary const& summary) {
    Counts const counts = counts_of(scene);
    Json cameras = Json::array();
    for (SceneCamera const& camera : scene.cameras)
        cameras.push_back({{"name", camera.name}, {"fov", glm::degrees(camera.vertical_fov)}});
    Json json{{"triangles", triangle_count(scene)},   {"instances", scene.instances.size()},
              {"meshes", scene.meshes.size()},        {"mesh_triangles", counts.mesh_triangles},
              {"vertices", counts.vertices},          {"materials", scene.materials.size()},
              {"textures", scene.pictures.size()},    {"geometry_bytes", counts.geometry_bytes},
              {"texture_bytes", counts.picture_bytes}};
    if (!scene.bounds.empty())
        json["bounds"] = {{"lowest", vector_json(scene.bounds.lowest)}, {"highest", vector_json(scene.bounds.highest)}};
    json["scenes"] = summary.scenes;
    json["shown_scene"] = summary.shown_scene;
    json["cameras"] = std::move(cameras);
    json["lights"] = summary.lights;
    json["animations"] = summary.animations;
    json["skins"] = summary.skins;
    json["extensions"] = summary.extensions;
    json["warnings"] = warnings_json(summary);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace alpenglow
