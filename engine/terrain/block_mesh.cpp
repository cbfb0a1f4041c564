#include "terrain/block_mesh.h"

#include <array>
#include <cassert>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int UNSIGNED_SHORT = 5123, FLOAT = 5126, ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963;

std::array<glm::vec2, 4> corners_of(glm::vec3 const& lowest, glm::vec3 const& highest) {
    return {glm::vec2(lowest.x, highest.z), {highest.x, highest.z}, {highest.x, lowest.z}, {lowest.x, lowest.z}};
}

} // namespace

std::uint16_t BlockMesh::add(glm::vec3 const& point) {
    assert(points_.size() < 65536);
    points_.push_back(point);
    return static_cast<std::uint16_t>(points_.size() - 1);
}

void BlockMesh::add_face(std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d) {
    indices_.insert(indices_.end(), {a, b, c, a, c, d});
}

void BlockMesh::add_box(glm::vec3 const& lowest, glm::vec3 const& highest) {
    add_column(corners_of(lowest, highest), lowest.y, highest.y);
}

void BlockMesh::add_slab(glm::vec3 const& lowest, glm::vec3 const& highest) {
    add_box(lowest, highest);
    auto const first = static_cast<std::uint16_t>(points_.size() - 8); // bottom and top by turns
    add_face(first + 6, first + 4, first + 2, first);
}

void BlockMesh::add_column(std::span<glm::vec2 const> corners, float bottom, float top) {
    auto const first = static_cast<std::uint16_t>(points_.size());
    auto const count = static_cast<std::uint16_t>(corners.size());
    for (glm::vec2 const& corner : corners) {
        add({corner.x, bottom, corner.y});
        add({corner.x, top, corner.y});
    }
    for (std::uint16_t i = 0; i < count; ++i) {
        auto const here = static_cast<std::uint16_t>(first + 2 * i);
        auto const next = static_cast<std::uint16_t>(first + 2 * ((i + 1) % count));
        add_face(here, next, next + 1, here + 1);
    }
    for (std::uint16_t i = 1; i + 1 < count; ++i) {
        std::uint16_t const top_of_first = first + 1;
        indices_.insert(indices_.end(), {top_of_first, static_cast<std::uint16_t>(top_of_first + 2 * i),
                                         static_cast<std::uint16_t>(top_of_first + 2 * (i + 1))});
    }
}

void BlockMesh::add_sheet(std::span<std::vector<glm::vec3> const> rows) {
    auto const first = static_cast<std::uint16_t>(points_.size());
    auto const along = static_cast<std::uint16_t>(rows.front().size());
    for (std::vector<glm::vec3> const& row : rows) {
        assert(row.size() == along);
        for (glm::vec3 const& point : row) add(point);
    }
    for (std::uint16_t row = 0; row + 1u < rows.size(); ++row) {
        for (std::uint16_t i = 0; i + 1 < along; ++i) {
            auto const at = static_cast<std::uint16_t>(first + row * along + i);
            auto const north = static_cast<std::uint16_t>(at + along);
            add_face(at, at + 1, north + 1, north);
        }
    }
}

GltfWriter BlockMesh::gltf(std::string const& name, glm::vec3 const& color) const {
    GltfWriter gltf;
    glm::vec3 lowest = points_.front(), highest = lowest;
    for (glm::vec3 const& p : points_) lowest = glm::min(lowest, p), highest = glm::max(highest, p);
    int const points = gltf.add_view(std::as_bytes(std::span(points_)), 0, ARRAY_BUFFER);
    int const indices = gltf.add_view(std::as_bytes(std::span(indices_)), 0, ELEMENT_ARRAY_BUFFER);
    gltf.json["scene"] = 0;
    gltf.json["scenes"] = {{{"name", name}, {"nodes", {0}}}};
    gltf.json["nodes"] = {{{"name", name}, {"mesh", 0}}};
    gltf.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"material", 0}}}}}};
    gltf.json["materials"] = {{{"pbrMetallicRoughness",
                                {{"baseColorFactor", {color.r, color.g, color.b, 1}},
                                 {"metallicFactor", 0},
                                 {"roughnessFactor", 1}}}}};
    gltf.json["accessors"] = {{{"bufferView", points},
                               {"componentType", FLOAT},
                               {"count", points_.size()},
                               {"type", "VEC3"},
                               {"min", {lowest.x, lowest.y, lowest.z}},
                               {"max", {highest.x, highest.y, highest.z}}},
                              {{"bufferView", indices},
                               {"componentType", UNSIGNED_SHORT},
                               {"count", indices_.size()},
                               {"type", "SCALAR"}}};
    return gltf;
}

} // namespace alpenglow
