#include "scene/gltf_nodes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace alpenglow::gltf {

namespace {

std::string pointer_to(std::size_t node) { return "/nodes/" + std::to_string(node); }

glm::dquat unit_rotation(std::vector<double> const& xyzw, std::size_t node, Report const& report) {
    glm::dquat const rotation(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    // A quaternion of signed normalized bytes is off by up to 4 * 0.5/127.
    if (std::abs(glm::length(rotation) - 1) > 0.016)
        report.refuse("ROTATION_NON_UNIT", pointer_to(node) + "/rotation", "is not a unit quaternion");
    return glm::normalize(rotation);
}

/// The parent of each node, -1 for none.
std::vector<int> find_parents(Document const& document, Report const& report) {
    std::vector<int> parents(document.nodes.size(), no_index);
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        std::vector<int> const& children = document.nodes[i].children;
        for (std::size_t c = 0; c < children.size(); ++c) {
            int& parent = parents[static_cast<std::size_t>(children[c])];
            if (parent != no_index) {
                report.refuse("NODE_PARENT_OVERRIDE", pointer_to(i) + "/children/" + std::to_string(c),
                              "node " + std::to_string(children[c]) + " has a second parent");
            }
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

/// With one parent each, a chain of parents that is longer than there are nodes is a cycle.
void check_depth(std::vector<int> const& parents, Report const& report) {
    std::vector<int> depths(parents.size(), 0); // 0: not known yet
    for (std::size_t i = 0; i < parents.size(); ++i) {
        std::vector<std::size_t> chain;
        int node = static_cast<int>(i);
        while (node != no_index && depths[static_cast<std::size_t>(node)] == 0) {
            chain.push_back(static_cast<std::size_t>(node));
            if (chain.size() > parents.size()) report.refuse("NODE_LOOP", pointer_to(i), "is its own ancestor");
            node = parents[static_cast<std::size_t>(node)];
        }
        int depth = node == no_index ? 0 : depths[static_cast<std::size_t>(node)];
        while (!chain.empty()) {
            depths[chain.back()] = ++depth;
            if (int const deepest = report.limits().deepest_node; depth > deepest) {
                report.refuse_beyond("deepest_node", deepest, pointer_to(chain.back()),
                                     "stands " + std::to_string(depth) + " nodes deep");
            }
            chain.pop_back();
        }
    }
}

bool is_finite(glm::dmat4 const& matrix) {
    double const* const first = glm::value_ptr(matrix);
    // Vertices are floats: what they can't hold is no place either.
    for (int i = 0; i < 16; ++i) {
        if (!(std::abs(first[i]) <= std::numeric_limits<float>::max())) return false;
    }
    return true;
}

} // namespace

glm::dmat4 node_matrix(NodePlacement const& placement, std::size_t node, Report const& report) {
    glm::dmat4 matrix(1);
    if (!placement.matrix.empty()) {
        matrix = glm::make_mat4(placement.matrix.data());
        if (matrix[0].w != 0 || matrix[1].w != 0 || matrix[2].w != 0 || matrix[3].w != 1) {
            report.refuse("VALUE_NOT_IN_RANGE", pointer_to(node) + "/matrix", "must end in the row 0 0 0 1");
        }
        return matrix;
    }
    if (!placement.translation.empty()) matrix = glm::translate(matrix, glm::make_vec3(placement.translation.data()));
    if (!placement.rotation.empty()) matrix *= glm::mat4_cast(unit_rotation(placement.rotation, node, report));
    if (!placement.scale.empty()) matrix = glm::scale(matrix, glm::make_vec3(placement.scale.data()));
    return matrix;
}

std::vector<PlacedNode> place_nodes(Document const& document, Report const& report) {
    std::vector<int> const parents = find_parents(document, report);
    check_depth(parents, report);
    std::vector<PlacedNode> open; // each with its parent's place
    std::vector<bool> seen(document.nodes.size());
    for (auto root = document.roots.rbegin(); root != document.roots.rend(); ++root) {
        auto const node = static_cast<std::size_t>(*root);
        if (parents[node] != no_index)
            report.refuse("SCENE_NON_ROOT_NODE", pointer_to(node), "is a root of the scene, but has a parent");
        if (seen[node]) report.refuse("NODE_PARENT_OVERRIDE", pointer_to(node), "stands twice in the scene");
        seen[node] = true;
        open.push_back({node, glm::dmat4(1)});
    }
    std::vector<PlacedNode> shown;
    while (!open.empty()) {
        PlacedNode const placed = open.back();
        open.pop_back();
        Node const& node = document.nodes[placed.node];
        glm::dmat4 const scene_from_node = placed.scene_from_node * node.parent_from_node;
        if (!is_finite(scene_from_node))
            report.refuse("VALUE_NOT_IN_RANGE", pointer_to(placed.node), "is placed out of a float's range");
        bool const hidden = glm::determinant(glm::dmat3(scene_from_node)) == 0;
        if ((node.mesh != no_index || node.camera != no_index) && !hidden)
            shown.push_back({placed.node, scene_from_node});
        if (int const most = report.limits().most_instances; shown.size() > static_cast<std::size_t>(most))
            report.refuse_beyond("most_instances", most, "/nodes", "places " + std::to_string(shown.size()) + " meshes");
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
            open.push_back({static_cast<std::size_t>(*child), scene_from_node});
        }
    }
    return shown;
}

std::vector<glm::dmat4> scene_from_nodes(Document const& document) {
    std::vector<bool> is_child(document.nodes.size());
    for (Node const& node : document.nodes)
        for (int const child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<std::size_t> open;
    std::vector<glm::dmat4> places(document.nodes.size());
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        places[i] = document.nodes[i].parent_from_node;
        if (!is_child[i]) open.push_back(i);
    }
    while (!open.empty()) {
        std::size_t const parent = open.back();
        open.pop_back();
        for (int const child : document.nodes[parent].children) {
            auto const i = static_cast<std::size_t>(child);
            places[i] = places[parent] * places[i];
            open.push_back(i);
        }
    }
    return places;
}

std::vector<SceneCamera> find_cameras(Document const& document, std::vector<PlacedNode> const& placed, Report& report) {
    std::vector<SceneCamera> cameras;
    for (auto const& [index, scene_from_node] : placed) {
        Node const& node = document.nodes[index];
        if (node.camera == no_index) continue;
        CameraSource const& source = document.cameras[static_cast<std::size_t>(node.camera)];
        bool const usable = source.vertical_fov >= 1e-5 && source.vertical_fov <= 3.1415; // [rad]
        if (!source.perspective || !usable) {
            report.warn(source.perspective ? "cameras that see a half space or more are left out"
                                           : "orthographic cameras are left out");
            continue;
        }
        std::string const name = !source.name.empty() ? source.name
                                 : !node.name.empty() ? node.name
                                                      : "camera " + std::to_string(cameras.size());
        cameras.push_back({name, scene_from_node, source.vertical_fov});
    }
    return cameras;
}

} // namespace alpenglow::gltf
