#include "scene/gltf_structure.h"

#include <glm/glm.hpp>

#include <set>

namespace alpenglow::gltf {

namespace {

using Json = nlohmann::json;

/// Its columns stand at right angles.
bool is_decomposable(Json const& matrix) {
    glm::dvec3 columns[3];
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) columns[c][r] = matrix[static_cast<std::size_t>(4 * c + r)].get<double>();
    auto const square = [](glm::dvec3 const& a, glm::dvec3 const& b) {
        // 5e-4 of a right angle: matrices are written with few digits.
        return std::abs(glm::dot(a, b)) <= 5e-4 * glm::length(a) * glm::length(b);
    };
    return square(columns[0], columns[1]) && square(columns[1], columns[2]) && square(columns[2], columns[0]);
}

void check_transform(Json const& node, std::string const& pointer, Report& report) {
    if (!node.contains("matrix")) return;
    if (node.contains("translation") || node.contains("rotation") || node.contains("scale"))
        report.say("NODE_MATRIX_TRS", pointer + "/matrix", "stands beside translation, rotation or scale: it counts");
    if (!is_decomposable(node["matrix"]))
        report.say("NODE_MATRIX_NON_TRS", pointer + "/matrix", "shears: it is no translation, rotation and scale");
}

void check_node(Json const& json, Json const& node, std::string const& pointer, Report& report) {
    check_transform(node, pointer, report);
    Json const& mesh_index = member(node, "mesh");
    if (mesh_index.is_null()) {
        for (char const* const key : {"skin", "weights"}) {
            if (node.contains(key)) report.say("UNSATISFIED_DEPENDENCY", pointer + "/" + key, "needs a mesh");
        }
        return;
    }
    Json const& mesh = referred(json, "meshes", mesh_index);
    Json const& first = mesh["primitives"][0];
    if (node.contains("skin") && !first["attributes"].contains("JOINTS_0"))
        report.say("NODE_SKIN_WITH_NON_SKINNED_MESH", pointer, "has a skin, its mesh no joints");
    if (node.contains("weights") && node["weights"].size() != member(first, "targets").size())
        report.say("NODE_WEIGHTS_INVALID", pointer + "/weights", "are not as many as its mesh has morph targets");
}

void check_camera(Json const& camera, std::string const& pointer, Report& report) {
    Json const& perspective = member(camera, "perspective");
    Json const& orthographic = member(camera, "orthographic");
    if (perspective.is_null() == orthographic.is_null())
        report.refuse("ONE_OF_MISMATCH", pointer, "must be either perspective or orthographic");
    Json const& lens = perspective.is_null() ? orthographic : perspective;
    if (lens.contains("zfar") && lens["zfar"].get<double>() <= lens["znear"].get<double>())
        report.say("CAMERA_ZFAR_LEQUAL_ZNEAR", pointer, "has a zfar that is not above znear");
    for (char const* const key : {"xmag", "ymag"}) {
        if (lens.contains(key) && lens[key].get<double>() == 0)
            report.say("CAMERA_XMAG_YMAG_ZERO", pointer + "/orthographic/" + key, "is 0");
    }
}

} // namespace

void check_nodes_and_cameras(Json const& json, Report& report) {
    std::set<std::size_t> children;
    for_each(json, "nodes", "", [&](Json const& node, std::string const& pointer) {
        check_node(json, node, pointer, report);
        for_each(node, "children", pointer,
                 [&](Json const& child, std::string const&) { children.insert(child.get<std::size_t>()); });
    });
    for_each(json, "scenes", "", [&](Json const& scene, std::string const& of_scene) {
        for_each(scene, "nodes", of_scene, [&](Json const& root, std::string const& pointer) {
            if (children.contains(root.get<std::size_t>()))
                report.say("SCENE_NON_ROOT_NODE", pointer, "is a root of the scene, but has a parent");
        });
    });
    for_each(json, "cameras", "",
             [&](Json const& camera, std::string const& pointer) { check_camera(camera, pointer, report); });
}

} // namespace alpenglow::gltf
