#include "scene/gltf_mesh.h"

#include "scene/gltf_accessor.h"
#include "scene/gltf_triangles.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>
#include <span>

namespace alpenglow::gltf {

namespace {

/// What an attribute may be made of (glTF 2.0, section 3.7.2.1): integers that must be
/// normalized, and those that KHR_mesh_quantization adds, normalized or not, as sets of bits. Floats always may be.
struct AttributeForm {
    std::string_view name;
    int fewest_rows, most_rows;
    unsigned normalized, quantized;
};

constexpr unsigned bits(std::initializer_list<Component> types) {
    unsigned result = 0;
    for (Component const type : types) result |= 1u << (static_cast<unsigned>(type) - 5120u);
    return result;
}

using enum Component;
constexpr auto forms = std::to_array<AttributeForm>({
    {"POSITION", 3, 3, 0, bits({int8, uint8, int16, uint16})},
    {"NORMAL", 3, 3, 0, bits({int8, int16})},
    {"TANGENT", 4, 4, 0, bits({int8, int16})},
    {"TEXCOORD_0", 2, 2, bits({uint8, uint16}), bits({int8, uint8, int16, uint16})},
    {"TEXCOORD_1", 2, 2, bits({uint8, uint16}), bits({int8, uint8, int16, uint16})},
    {"COLOR_0", 3, 4, bits({uint8, uint16}), 0},
});

void check_form(Accessor const& accessor, AttributeForm const& form, bool quantized, std::string const& pointer,
                Report const& report) {
    unsigned const bit = bits({accessor.type});
    if (accessor.columns != 1 || accessor.rows < form.fewest_rows || accessor.rows > form.most_rows) {
        report.refuse("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", pointer,
                      std::string(form.name) + " has the wrong number of components");
    }
    bool const core = accessor.type == float32 || ((form.normalized & bit) != 0 && accessor.normalized);
    if (core || (quantized && (form.quantized & bit) != 0)) return;
    report.refuse("MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", pointer,
                  std::string(form.name) + " has components of a type that it can't have",
                  (form.quantized & bit) != 0 ? "KHR_mesh_quantization would allow it" : "");
}

glm::vec3 unit_or_up(glm::vec3 const& v) {
    float const length = glm::length(v);
    return length > 1e-12f && std::isfinite(length) ? v / length : glm::vec3(0, 1, 0);
}

glm::vec4 unit_tangent(float const* v) {
    glm::vec3 const direction(v[0], v[1], v[2]);
    float const length = glm::length(direction);
    if (!(length > 1e-12f && std::isfinite(length))) return glm::vec4(0);
    return {direction / length, v[3] < 0 ? -1.0f : 1.0f};
}

Box bounds_of(Mesh const& mesh, MeshPart const& part) {
    Box box;
    for (std::uint32_t const index : std::span(mesh.indices).subspan(part.first_index, part.index_count)) {
        box.include(glm::dvec3(mesh.vertices[index].position));
    }
    return box;
}

} // namespace

void MeshBuilder::claim(std::size_t index) {
    std::set<std::map<std::string, int>> known;
    for (Primitive const& primitive : document_.meshes[index].primitives) {
        auto const position = primitive.attributes.find("POSITION");
        if (primitive.mode < 4 || position == primitive.attributes.end()) continue;
        std::size_t const count = document_.accessors[static_cast<std::size_t>(position->second)].count;
        std::size_t const corners = primitive.indices == no_index
                                        ? count
                                        : document_.accessors[static_cast<std::size_t>(primitive.indices)].count;
        std::size_t const indices =
            static_cast<TriangleMode>(primitive.mode) == TriangleMode::list ? corners : 3 * corners;
        total_indices_ += indices;
        if (!primitive.attributes.contains("NORMAL") || !primitive.targets.empty())
            total_vertices_ += std::max(count, indices);
        else if (known.insert(primitive.attributes).second)
            total_vertices_ += count;
    }
    std::string const pointer = fmt::format("/meshes/{}", index);
    GltfLimits const& limits = report_.limits();
    if (total_indices_ > static_cast<std::size_t>(limits.most_indices))
        report_.refuse_beyond("most_indices", limits.most_indices, pointer,
                              fmt::format("makes {} indices in all", total_indices_));
    if (total_vertices_ > static_cast<std::size_t>(limits.most_vertices))
        report_.refuse_beyond("most_vertices", limits.most_vertices, pointer,
                              fmt::format("makes {} vertices in all", total_vertices_));
}

Mesh MeshBuilder::build(std::size_t index, Pose const& pose) {
    MeshSource const& source = document_.meshes[index];
    Mesh mesh;
    mesh.name = source.name;
    FirstVertices shared;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        add_primitive(mesh, shared, source.primitives[i], pose,
                      fmt::format("/meshes/{}/primitives/{}", index, i));
    }
    return mesh;
}

void MeshBuilder::add_primitive(Mesh& mesh, FirstVertices& shared, Primitive const& primitive, Pose const& pose,
                                std::string const& pointer) {
    if (primitive.mode < 4) return report_.warn("points and lines are left out");
    auto const position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return report_.warn("primitives without POSITION are left out");

    std::size_t const count = document_.accessors[static_cast<std::size_t>(position->second)].count;
    std::vector<std::uint32_t> indices = read_triangles(primitive, count);
    if (indices.empty()) return report_.warn("primitives without a whole triangle are left out");
    std::uint32_t const first_vertex = add_vertices(mesh, shared, primitive, pose, indices, pointer);
    for (std::uint32_t& corner : indices) corner += first_vertex;

    MeshPart part;
    part.first_index = static_cast<std::uint32_t>(mesh.indices.size());
    part.index_count = static_cast<std::uint32_t>(indices.size());
    used_default_material_ |= primitive.material == no_index;
    part.material =
        primitive.material == no_index ? default_material() : static_cast<std::uint32_t>(primitive.material);
    mesh.indices.insert(mesh.indices.end(), indices.begin(), indices.end());
    part.bounds = bounds_of(mesh, part);
    mesh.parts.push_back(part);
}

std::vector<std::uint32_t> MeshBuilder::read_triangles(Primitive const& primitive, std::size_t vertices) {
    bool const counted = primitive.indices == no_index;
    return triangles_from(static_cast<TriangleMode>(primitive.mode),
                          counted ? counted_indices(vertices)
                                  : read_indices(document_, primitive.indices, vertices, report_));
}

/// Returns where the primitive's vertices begin. Primitives with the same attributes share them, unless they have morph
/// targets or their normals have to be made, which rewrites `indices`.
std::uint32_t MeshBuilder::add_vertices(Mesh& mesh, FirstVertices& shared, Primitive const& primitive, Pose const& pose,
                                        std::vector<std::uint32_t>& indices, std::string const& pointer) {
    bool const flat = !primitive.attributes.contains("NORMAL");
    auto const first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
    if (!flat && primitive.targets.empty()) {
        auto const [known, added] = shared.try_emplace(primitive.attributes, first_vertex);
        if (!added) return known->second;
    }
    std::size_t const count = document_.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))].count;
    std::vector<Vertex> vertices = read_vertices(primitive, count, pointer);
    apply_targets(vertices, primitive, pose, document_, pointer, report_);
    apply_skin(vertices, primitive, pose, document_, pointer, report_);
    if (flat) make_flat(vertices, indices);
    if (mesh.vertices.empty())
        mesh.vertices = std::move(vertices);
    else
        mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
    return first_vertex;
}

std::vector<Vertex> MeshBuilder::read_vertices(Primitive const& primitive, std::size_t count,
                                               std::string const& pointer) {
    std::vector<Vertex> vertices(count);
    for (auto const& [name, accessor] : primitive.attributes) {
        read_attribute(vertices, name, accessor, pointer + "/attributes/" + printable(name));
    }
    return vertices;
}

void MeshBuilder::read_attribute(std::vector<Vertex>& vertices, std::string const& name, int index,
                                 std::string const& pointer) {
    auto const form = std::ranges::find(forms, name, &AttributeForm::name);
    if (form == forms.end()) return;
    Accessor const& accessor = document_.accessors[static_cast<std::size_t>(index)];
    check_form(accessor, *form, document_.quantized, pointer, report_);
    if (accessor.count != vertices.size()) {
        report_.refuse("MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", pointer,
                       "has " + std::to_string(accessor.count) + " elements, POSITION " +
                           std::to_string(vertices.size()));
    }
    if (name == "POSITION") {
        read_vectors<3>(document_, index, report_, [&](std::size_t i, float const* v) {
            vertices[i].position = {v[0], v[1], v[2]};
        });
    } else if (name == "NORMAL") {
        read_vectors<3>(document_, index, report_, [&](std::size_t i, float const* v) {
            vertices[i].normal = unit_or_up({v[0], v[1], v[2]});
        });
    } else if (name == "TANGENT") {
        read_vectors<4>(document_, index, report_,
                        [&](std::size_t i, float const* v) { vertices[i].tangent = unit_tangent(v); });
    } else if (name == "TEXCOORD_0") {
        read_vectors<2>(document_, index, report_, [&](std::size_t i, float const* v) {
            vertices[i].uv0 = {v[0], v[1]};
        });
    } else if (name == "TEXCOORD_1") {
        read_vectors<2>(document_, index, report_, [&](std::size_t i, float const* v) {
            vertices[i].uv1 = {v[0], v[1]};
        });
    } else {
        read_vectors<4>(document_, index, report_, [&](std::size_t i, float const* v) {
            vertices[i].color = glm::clamp(glm::vec4(v[0], v[1], v[2], v[3]), 0.0f, 1.0f);
        });
    }
}

} // namespace alpenglow::gltf
