#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_pose.h"
#include "scene/gltf_report.h"

namespace alpenglow::gltf {

/// Turns glTF meshes into ours, and counts what they take, so that a small file can't ask for a huge scene by naming
/// the same bytes again and again.
class MeshBuilder {
public:
    MeshBuilder(Document const& document, Report& report) : document_(document), report_(report) {}

    /// Counts what `mesh` will take at most, in a pose of these morph weights and so many joints. Throws
    /// Error(bad_input) beyond the limits. Call it for every mesh before the first is built.
    void claim(std::size_t mesh, std::vector<double> const& weights, std::size_t joints);
    /// `mesh` of the document as triangles, in `pose`; without parts where it holds none. Materials are numbered as in the
    /// document; a part without one has `default_material()`. Throws Error(bad_input).
    Mesh build(std::size_t mesh, Pose const& pose);

    std::uint32_t default_material() const { return static_cast<std::uint32_t>(document_.materials.size()); }
    bool used_default_material() const { return used_default_material_; }

private:
    /// Where the vertices of each set of attributes begin in the mesh that is being built.
    using FirstVertices = std::map<std::map<std::string, int>, std::uint32_t>;

    void add_primitive(Mesh& mesh, FirstVertices& shared, Primitive const& primitive, Pose const& pose,
                       std::string const& pointer);
    std::vector<std::uint32_t> read_triangles(Primitive const& primitive, std::size_t vertices);
    std::uint32_t add_vertices(Mesh& mesh, FirstVertices& shared, Primitive const& primitive, Pose const& pose,
                               std::vector<std::uint32_t>& indices, std::string const& pointer);
    std::vector<Vertex> read_vertices(Primitive const& primitive, std::size_t count, std::string const& pointer);
    void read_attribute(std::vector<Vertex>& vertices, std::string const& name, int accessor,
                        std::string const& pointer);

    Document const& document_;
    Report& report_;
    bool used_default_material_ = false;
    std::size_t total_vertices_ = 0, total_indices_ = 0;
};

} // namespace alpenglow::gltf
