#include "scene/gltf_structure.h"

#include <numeric>
#include <optional>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

constexpr std::size_t nobody = ~std::size_t{0};

/// The parent of each node; `nobody` for roots, and nothing where a node has two or is its own ancestor, which is said
/// where nodes are placed.
std::optional<std::vector<std::size_t>> find_parents(Json const& json) {
    std::vector<std::size_t> parents(member(json, "nodes").size(), nobody);
    bool tree = true;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        for (Json const& child : member(json["nodes"][i], "children")) {
            std::size_t& parent = parents[child.get<std::size_t>()];
            tree = tree && parent == nobody;
            parent = i;
        }
    }
    if (!tree) return {};
    // Each node is visited from its root, so that what no root reaches is a cycle.
    std::size_t reached = 0;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == nobody) open.push_back(i);
    while (!open.empty()) {
        std::size_t const node = open.back();
        open.pop_back();
        ++reached;
        for (Json const& child : member(json["nodes"][node], "children")) open.push_back(child.get<std::size_t>());
    }
    if (reached != parents.size()) return {};
    return parents;
}

class SkinCheck {
public:
    SkinCheck(Json const& json, std::vector<std::size_t> const& parents, Report& report)
        : json_(json), parents_(parents), report_(report), roots_(parents.size(), nobody) {
        for (std::size_t i = 0; i < parents.size(); ++i) find_root(i);
    }

    void check(Json const& skin, std::string const& pointer) {
        check_roots(skin, pointer);
        Json const& matrices = member(skin, "inverseBindMatrices");
        if (matrices.is_null()) return;
        std::string const at = pointer + "/inverseBindMatrices";
        Json const& accessor = referred(json_, "accessors", matrices);
        if (has_stride(json_, accessor))
            report_.say("SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", at, "has a view with a stride");
        if (format_of(accessor) != "MAT4 5126") report_.say("SKIN_IBM_INVALID_FORMAT", at, "is not MAT4 of floats");
        if (accessor["count"] < skin["joints"].size())
            report_.say("INVALID_IBM_ACCESSOR_COUNT", at, "has fewer elements than there are joints");
    }

    /// A skinned mesh and its joints stand in the same scene.
    void check_scene(Json const& scene, std::string const&) {
        std::vector<bool> shown(parents_.size());
        for (Json const& root : member(scene, "nodes")) shown[root.get<std::size_t>()] = true;
        for (std::size_t i = 0; i < parents_.size(); ++i) {
            Json const& skin = member(json_["nodes"][i], "skin");
            if (skin.is_null() || !shown[roots_[i]]) continue;
            std::size_t const joint = referred(json_, "skins", skin)["joints"][0].get<std::size_t>();
            if (!shown[roots_[joint]])
                report_.say("NODE_SKIN_NO_SCENE", fmt::format("/nodes/{}", i), "has a skin of joints in another scene");
        }
    }

private:
    void find_root(std::size_t node) {
        std::vector<std::size_t> chain;
        std::size_t top = node;
        while (roots_[top] == nobody && parents_[top] != nobody) {
            chain.push_back(top);
            top = parents_[top];
        }
        std::size_t const root = roots_[top] == nobody ? top : roots_[top];
        roots_[top] = root;
        for (std::size_t const below : chain) roots_[below] = root;
    }

    bool is_above(std::size_t ancestor, std::size_t node) const {
        for (int i = 0; i < report_.limits().deepest_node && node != ancestor && parents_[node] != nobody; ++i)
            node = parents_[node];
        return node == ancestor;
    }

    void check_roots(Json const& skin, std::string const& pointer) {
        Json const& joints = skin["joints"];
        std::size_t const root = roots_[joints[0].get<std::size_t>()];
        for (Json const& joint : joints) {
            if (roots_[joint.get<std::size_t>()] == root) continue;
            return report_.say("SKIN_NO_COMMON_ROOT", pointer + "/joints", "have no common root");
        }
        Json const& skeleton = member(skin, "skeleton");
        // The first joint stands for all: a chain of ancestors for each would take long in a deep tree.
        if (!skeleton.is_null() && !is_above(skeleton.get<std::size_t>(), joints[0].get<std::size_t>()))
            report_.say("SKIN_SKELETON_INVALID", pointer + "/skeleton", "is no root of the joints");
    }

    Json const& json_;
    std::vector<std::size_t> const& parents_;
    Report& report_;
    std::vector<std::size_t> roots_; ///< of each node
};

} // namespace

void check_skins(Json const& json, Report& report) {
    std::optional<std::vector<std::size_t>> const parents = find_parents(json);
    if (!parents || !json.contains("skins")) return;
    SkinCheck check(json, *parents, report);
    for_each(json, "skins", "", [&](Json const& skin, std::string const& pointer) { check.check(skin, pointer); });
    // Nodes times scenes; files have one or a few scenes.
    constexpr std::size_t most_scenes = 16;
    if (member(json, "scenes").size() > most_scenes) return;
    for_each(json, "scenes", "",
             [&](Json const& scene, std::string const& pointer) { check.check_scene(scene, pointer); });
}

} // namespace alpenglow::gltf
