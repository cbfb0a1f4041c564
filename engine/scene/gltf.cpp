#include "scene/gltf.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_contents.h"
#include "scene/gltf_draco.h"
#include "scene/gltf_mesh.h"
#include "scene/gltf_meshopt.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_parse.h"
#include "scene/gltf_pictures.h"
#include "scene/gltf_resources.h"
#include "scene/gltf_schema.h"
#include "scene/gltf_source.h"
#include "scene/gltf_structure.h"
#include "scene/gltf_summary.h"

#include <map>
#include <set>

namespace alpenglow {

namespace {

gltf::Document read_document(GltfOptions const& options, GltfSummary& summary, gltf::Report& report) {
    gltf::Source source = gltf::read_source(report);
    gltf::check_version(source.json, report);
    gltf::check_schema(source.json, report);
    gltf::check_structure(source.json, report);
    gltf::check_extensions(source.json, report);
    gltf::summarize(source.json, summary, report);
    summary.shown_scene = options.scene_index.value_or(source.json.value("scene", 0));
    gltf::Document document = gltf::parse_document(source.json, options.scene_index, report);
    document.buffers = gltf::read_buffers(source, report);
    gltf::decompress_views(document, source.json, report);
    gltf::check_views(document, report);
    gltf::decompress_primitives(document, report);
    gltf::check_accessors(document, report);
    gltf::check_contents(source.json, document, report);
    return document;
}

/// The poses in which nodes show their meshes. A mesh in a pose of its own belongs to one node.
class Poses {
public:
    Poses(gltf::Document const& document, gltf::Report const& report)
        : document_(document), report_(report),
          scene_from_node_(document.skins.empty() ? std::vector<glm::dmat4>() : gltf::scene_from_nodes(document)) {}

    /// Moves `scene_from_mesh` where a skin decides: to its first joint.
    gltf::Pose of(gltf::Node const& node, glm::dmat4& scene_from_mesh) const {
        gltf::Pose pose{node.weights.empty() ? document_.meshes[static_cast<std::size_t>(node.mesh)].weights
                                             : node.weights};
        if (node.skin == gltf::no_index) return pose;
        int const first = document_.skins[static_cast<std::size_t>(node.skin)].joints.front();
        glm::dvec4 const origin = scene_from_node_[static_cast<std::size_t>(first)][3];
        scene_from_mesh = glm::dmat4(1);
        scene_from_mesh[3] = origin;
        pose.mesh_from_bind = gltf::joint_matrices(document_, node.skin, scene_from_node_, glm::dvec3(origin), report_);
        return pose;
    }

private:
    gltf::Document const& document_;
    gltf::Report const& report_;
    std::vector<glm::dmat4> scene_from_node_;
};

/// Builds the meshes that are placed, each once for each pose, and leaves out those that hold no triangle.
void build_meshes(Scene& scene, std::vector<gltf::PlacedNode> const& placed, gltf::Document const& document,
                  gltf::Report& report) {
    constexpr std::uint32_t without_triangles = ~0u;
    gltf::MeshBuilder builder(document, report);
    Poses const poses(document, report);
    // Of each mesh, and of the node that has it in a pose of its own.
    using Key = std::pair<int, std::size_t>;
    auto const key_of = [&](std::size_t index) {
        gltf::Node const& node = document.nodes[index];
        bool const own = node.skin != gltf::no_index || !node.weights.empty();
        return Key(node.mesh, own ? index : document.nodes.size());
    };
    std::set<Key> claimed;
    for (gltf::PlacedNode const& one : placed) {
        Key const key = key_of(one.node);
        if (key.first != gltf::no_index && claimed.insert(key).second)
            builder.claim(static_cast<std::size_t>(key.first));
    }
    std::map<Key, std::uint32_t> numbers;
    scene.meshes.reserve(claimed.size());
    for (auto [index, scene_from_mesh] : placed) {
        Key const key = key_of(index);
        if (key.first == gltf::no_index) continue;
        auto const [number, is_new] = numbers.try_emplace(key, without_triangles);
        gltf::Pose const pose = poses.of(document.nodes[index], scene_from_mesh);
        if (is_new) {
            Mesh mesh = builder.build(static_cast<std::size_t>(key.first), pose);
            if (!mesh.parts.empty()) number->second = static_cast<std::uint32_t>(scene.meshes.size());
            if (!mesh.parts.empty()) scene.meshes.push_back(std::move(mesh));
        }
        if (number->second != without_triangles) scene.instances.push_back({number->second, scene_from_mesh});
    }
    if (builder.used_default_material()) scene.materials.push_back({});
}

Scene load(GltfOptions const& options, GltfSummary& summary, gltf::Report& report) {
    gltf::Document const document = read_document(options, summary, report);
    std::vector<gltf::PlacedNode> const placed = gltf::place_nodes(document, report);
    Scene scene;
    scene.name = report.file().stem().string();
    scene.materials = document.materials;
    build_meshes(scene, placed, document, report);
    scene.cameras = gltf::find_cameras(document, placed, report);
    scene.pictures = gltf::load_pictures(document, scene.materials, options.largest_texture, report);
    scene.bounds = scene_bounds(scene);
    if (scene.instances.empty()) report.warn("the scene holds no triangle");
    report.log_counts();
    return scene;
}

} // namespace

Scene load_gltf(std::filesystem::path const& file, GltfOptions const& options, GltfSummary* summary) {
    GltfSummary unwanted;
    GltfSummary& found = summary ? *summary : unwanted;
    found = {};
    gltf::Report report(file, options.limits, found.warnings);
    return load(options, found, report);
}

} // namespace alpenglow
