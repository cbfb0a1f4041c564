#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

namespace alpenglow::gltf {

/// A node's own placement as the file gives it; empty where it doesn't.
struct NodePlacement {
    std::vector<double> const& matrix;      ///< 16, by columns
    std::vector<double> const& translation; ///< 3
    std::vector<double> const& rotation;    ///< 4, unit quaternion x y z w
    std::vector<double> const& scale;       ///< 3
};
/// Throws Error(bad_input) where the matrix is not affine or the rotation is no rotation.
glm::dmat4 node_matrix(NodePlacement const& placement, std::size_t node, Report const& report);

/// A node of the shown scene that has a mesh or a camera.
struct PlacedNode {
    std::size_t node;
    glm::dmat4 scene_from_node;
};
/// Nodes that a scale of zero hides are left out. Throws Error(bad_input) on cycles, several parents, deep chains.
std::vector<PlacedNode> place_nodes(Document const& document, Report const& report);

/// Where every node stands, whether the shown scene holds it or not; after place_nodes has passed them.
std::vector<glm::dmat4> scene_from_nodes(Document const& document);

/// The perspective cameras among `placed`, named as the file names them, or their nodes. Others are left out, with a
/// warning.
std::vector<SceneCamera> find_cameras(Document const& document, std::vector<PlacedNode> const& placed, Report& report);

} // namespace alpenglow::gltf
