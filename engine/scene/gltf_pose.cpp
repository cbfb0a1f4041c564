#include "scene/gltf_pose.h"

#include "scene/gltf_accessor.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace alpenglow::gltf {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void check_shape(Document const& document, int index, int rows, std::size_t count, std::string const& pointer,
                 Report const& report) {
    Accessor const& accessor = document.accessors[at(index)];
    if (accessor.columns != 1 || accessor.rows != rows) report.fail(pointer, "has the wrong number of components");
    if (accessor.count != count)
        report.fail(pointer, fmt::format("has {} elements, POSITION {}", accessor.count, count));
}

/// Adds `weight` times the three-component accessor to what `member` gives of each vertex.
template <class Member>
void add_target(std::vector<Vertex>& vertices, int index, double weight, std::string const& pointer,
                Document const& document, Report const& report, Member const& member) {
    check_shape(document, index, 3, vertices.size(), pointer, report);
    auto const share = static_cast<float>(weight);
    // The elements come once more where a sparse accessor replaces them: the last one counts.
    std::vector<glm::vec3> added(vertices.size());
    read_vectors<3>(document, index, report,
                    [&](std::size_t i, float const* v) { added[i] = share * glm::vec3(v[0], v[1], v[2]); });
    for (std::size_t i = 0; i < added.size(); ++i) member(vertices[i], added[i]);
}

void make_unit(std::vector<Vertex>& vertices) {
    for (Vertex& vertex : vertices) {
        float const length = glm::length(vertex.normal), along = glm::length(glm::vec3(vertex.tangent));
        vertex.normal = length > 0 ? vertex.normal / length : glm::vec3(0, 1, 0);
        vertex.tangent = along > 0 ? glm::vec4(glm::vec3(vertex.tangent) / along, vertex.tangent.w) : glm::vec4(0);
    }
}

glm::dmat4 blend(glm::vec4 const& joints, glm::vec4 const& weights, Pose const& pose, std::string const& pointer,
                 Report const& report) {
    glm::dmat4 sum(0);
    for (int i = 0; i < 4; ++i) {
        if (weights[i] == 0) continue;
        auto const joint = static_cast<std::size_t>(joints[i]);
        if (joint >= pose.mesh_from_bind.size())
            report.fail(pointer, fmt::format("names joint {}, but the skin has {}", joint, pose.mesh_from_bind.size()));
        sum += static_cast<double>(weights[i]) * pose.mesh_from_bind[joint];
    }
    return sum;
}

/// The vectors of attribute `name`, one for each vertex; none where the primitive has no such attribute.
std::vector<glm::vec4> read_quads(Primitive const& primitive, std::string const& name, std::size_t count,
                                  Document const& document, std::string const& pointer, Report const& report) {
    auto const own = primitive.attributes.find(name);
    if (own == primitive.attributes.end()) return {};
    check_shape(document, own->second, 4, count, pointer + "/attributes/" + name, report);
    std::vector<glm::vec4> values(count);
    read_vectors<4>(document, own->second, report, [&](std::size_t i, float const* v) {
        values[i] = {v[0], v[1], v[2], v[3]};
    });
    return values;
}

void move(Vertex& vertex, glm::dmat4 const& mesh_from_bind) {
    glm::dmat3 const m(mesh_from_bind);
    glm::dmat3 const cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    vertex.position = glm::vec3(mesh_from_bind * glm::dvec4(vertex.position, 1));
    double const sign = glm::determinant(m) < 0 ? -1 : 1;
    vertex.normal = glm::vec3(sign * (cofactor * glm::dvec3(vertex.normal)));
    vertex.tangent = glm::vec4(glm::vec3(m * glm::dvec3(vertex.tangent)), vertex.tangent.w);
}

std::vector<glm::dmat4> read_matrices(Document const& document, int index, std::size_t count, Report const& report) {
    if (index == no_index) return std::vector<glm::dmat4>(count, glm::dmat4(1));
    std::vector<glm::dmat4> matrices(document.accessors[at(index)].count);
    read_vectors<16>(document, index, report,
                     [&](std::size_t i, float const* values) { matrices[i] = glm::dmat4(glm::make_mat4(values)); });
    matrices.resize(count, glm::dmat4(1));
    return matrices;
}

} // namespace

void apply_targets(std::vector<Vertex>& vertices, Primitive const& primitive, Pose const& pose,
                   Document const& document, std::string const& pointer, Report const& report) {
    std::size_t const targets = std::min(primitive.targets.size(), pose.weights.size());
    bool moved = false;
    for (std::size_t t = 0; t < targets; ++t) {
        double const weight = pose.weights[t];
        if (weight == 0) continue;
        moved = true;
        for (auto const& [name, index] : primitive.targets[t]) {
            std::string const where = fmt::format("{}/targets/{}/{}", pointer, t, printable(name));
            auto const add = [&](auto const& member) {
                add_target(vertices, index, weight, where, document, report, member);
            };
            if (name == "POSITION") add([](Vertex& vertex, glm::vec3 const& v) { vertex.position += v; });
            if (name == "NORMAL") add([](Vertex& vertex, glm::vec3 const& v) { vertex.normal += v; });
            if (name == "TANGENT") add([](Vertex& vertex, glm::vec3 const& v) { vertex.tangent += glm::vec4(v, 0); });
        }
    }
    if (moved) make_unit(vertices);
}

void apply_skin(std::vector<Vertex>& vertices, Primitive const& primitive, Pose const& pose, Document const& document,
                std::string const& pointer, Report const& report) {
    if (pose.mesh_from_bind.empty()) return;
    std::vector<glm::dmat4> sums(vertices.size(), glm::dmat4(0));
    std::vector<double> totals(vertices.size());
    for (char const* const set : {"0", "1"}) {
        auto const quads = [&](std::string const& name) {
            return read_quads(primitive, name + set, vertices.size(), document, pointer, report);
        };
        std::vector<glm::vec4> const joints = quads("JOINTS_"), weights = quads("WEIGHTS_");
        if (joints.size() != weights.size()) continue; // one without the other was warned of
        for (std::size_t i = 0; i < joints.size(); ++i) {
            sums[i] += blend(joints[i], weights[i], pose, pointer + "/attributes/JOINTS_" + set, report);
            totals[i] += weights[i].x + weights[i].y + weights[i].z + weights[i].w;
        }
    }
    // A vertex without weights has no place: it stays where the bind pose has it.
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (totals[i] > 0) move(vertices[i], sums[i] / totals[i]);
    make_unit(vertices);
}

std::vector<glm::dmat4> joint_matrices(Document const& document, int skin,
                                       std::vector<glm::dmat4> const& scene_from_node, glm::dvec3 const& origin,
                                       Report const& report) {
    Skin const& source = document.skins[at(skin)];
    std::vector<glm::dmat4> matrices =
        read_matrices(document, source.inverse_bind_matrices, source.joints.size(), report);
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        glm::dmat4 mesh_from_joint = scene_from_node[at(source.joints[i])];
        mesh_from_joint[3] -= glm::dvec4(origin, 0);
        matrices[i] = mesh_from_joint * matrices[i];
    }
    return matrices;
}

} // namespace alpenglow::gltf
