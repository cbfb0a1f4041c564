#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_report.h"

namespace alpenglow::gltf {

/// How one node shows its mesh: which share of each morph target, and by which joints.
struct Pose {
    std::vector<double> weights = {};             ///< of the morph targets; none: all 0
    std::vector<glm::dmat4> mesh_from_bind = {};  ///< of each joint; none: no skin

    bool empty() const { return weights.empty() && mesh_from_bind.empty(); }
};

/// Adds `primitive`'s morph targets to its vertices. Throws Error(bad_input).
void apply_targets(std::vector<Vertex>& vertices, Primitive const& primitive, Pose const& pose,
                   Document const& document, std::string const& pointer, Report const& report);

/// Moves vertices by their joints. Throws Error(bad_input) where a joint does not exist.
void apply_skin(std::vector<Vertex>& vertices, Primitive const& primitive, Pose const& pose, Document const& document,
                std::string const& pointer, Report const& report);

/// Where the joints of `skin` take the vertices of its bind pose, in a frame that stands at `origin` with the scene's
/// axes. `scene_from_node`: of every node. Throws Error(bad_input).
std::vector<glm::dmat4> joint_matrices(Document const& document, int skin,
                                       std::vector<glm::dmat4> const& scene_from_node, glm::dvec3 const& origin,
                                       Report const& report);

} // namespace alpenglow::gltf
