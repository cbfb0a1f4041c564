#include "scene/gltf_triangles.h"

#include <array>
#include <numeric>

namespace alpenglow::gltf {

std::vector<std::uint32_t> counted_indices(std::size_t count) {
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

std::vector<std::uint32_t> triangles_from(TriangleMode mode, std::vector<std::uint32_t> corners) {
    if (mode == TriangleMode::list) {
        corners.resize(corners.size() / 3 * 3);
        return corners;
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(corners.size() * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        std::size_t const odd = i % 2;
        auto const [a, b, c] = mode == TriangleMode::strip
                                   ? std::array{corners[i], corners[i + 1 + odd], corners[i + 2 - odd]}
                                   : std::array{corners[i + 1], corners[i + 2], corners[0]};
        if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
    }
    return indices;
}

void make_flat(std::vector<Vertex>& vertices, std::vector<std::uint32_t>& indices) {
    std::vector<Vertex> corners(indices.size());
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        for (std::size_t c = 0; c < 3; ++c) corners[i + c] = vertices[indices[i + c]];
        // In double: the cross product of two short edges underflows a float.
        glm::dvec3 const a(corners[i].position), b(corners[i + 1].position), c(corners[i + 2].position);
        glm::dvec3 const normal = glm::cross(b - a, c - a);
        double const length = glm::length(normal);
        for (std::size_t k = i; k < i + 3; ++k) {
            corners[k].normal = length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 1, 0);
            corners[k].tangent = glm::vec4(0);
        }
    }
    vertices = std::move(corners);
    indices = counted_indices(indices.size());
}

} // namespace alpenglow::gltf
