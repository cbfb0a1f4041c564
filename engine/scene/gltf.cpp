#include "scene/gltf.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_contents.h"
#include "scene/gltf_mesh.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_parse.h"
#include "scene/gltf_pictures.h"
#include "scene/gltf_resources.h"
#include "scene/gltf_schema.h"
#include "scene/gltf_source.h"
#include "scene/gltf_structure.h"

#include <set>

namespace alpenglow {

namespace {

gltf::Document read_document(gltf::Report& report) {
    gltf::Source source = gltf::read_source(report);
    gltf::check_version(source.json, report);
    gltf::check_schema(source.json, report);
    gltf::check_structure(source.json, report);
    gltf::check_extensions(source.json, report);
    gltf::Document document = gltf::parse_document(source.json, report);
    document.buffers = gltf::read_buffers(source, report);
    gltf::check_accessors(document, report);
    gltf::check_contents(source.json, document, report);
    return document;
}

/// Builds the meshes that are placed, each once, and leaves out the instances of those that hold no triangle.
void build_meshes(Scene& scene, std::vector<Instance> const& placed, gltf::Document const& document,
                  gltf::Report& report) {
    constexpr std::uint32_t not_built = ~0u, without_triangles = ~0u - 1;
    gltf::MeshBuilder builder(document, report);
    std::set<std::uint32_t> shown;
    for (Instance const& instance : placed) {
        if (shown.insert(instance.mesh).second) builder.claim(instance.mesh);
    }
    std::vector<std::uint32_t> numbers(document.meshes.size(), not_built);
    scene.meshes.reserve(shown.size());
    for (Instance const& instance : placed) {
        std::uint32_t& number = numbers[instance.mesh];
        if (number == not_built) {
            Mesh mesh = builder.build(instance.mesh);
            number = mesh.parts.empty() ? without_triangles : static_cast<std::uint32_t>(scene.meshes.size());
            if (!mesh.parts.empty()) scene.meshes.push_back(std::move(mesh));
        }
        if (number != without_triangles) scene.instances.push_back({number, instance.scene_from_mesh});
    }
    if (builder.used_default_material()) scene.materials.push_back({});
}

} // namespace

Scene load_gltf(std::filesystem::path const& file, GltfOptions const& options) {
    gltf::Report report(file, options.limits, options.warnings);
    gltf::Document const document = read_document(report);
    Scene scene;
    scene.name = file.stem().string();
    scene.materials = document.materials;
    build_meshes(scene, gltf::place_nodes(document, report), document, report);
    scene.pictures = gltf::load_pictures(document, scene.materials, options.largest_texture, report);
    scene.bounds = scene_bounds(scene);
    if (scene.instances.empty()) report.warn("the scene holds no triangle");
    report.log_counts();
    return scene;
}

} // namespace alpenglow
