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

/// Each node of the shown scene that has a mesh, with its place. `Instance::mesh` is an index into Document::meshes.
/// Nodes that a scale of zero hides are left out. Throws Error(bad_input) on cycles, several parents, deep chains.
std::vector<Instance> place_nodes(Document const& document, Report const& report);

} // namespace alpenglow::gltf
