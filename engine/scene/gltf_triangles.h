#pragma once

#include "scene/scene.h"

namespace alpenglow::gltf {

/// As glTF numbers them.
enum class TriangleMode { list = 4, strip = 5, fan = 6 };

/// 0, 1, 2, … : the indices of a primitive that has none.
std::vector<std::uint32_t> counted_indices(std::size_t count);

/// Lists of three indices with the winding that glTF 2.0, section 3.7.2.1, gives each mode. Triangles of strips and
/// fans that use a vertex twice are dropped, as are vertices that don't make a whole triangle.
std::vector<std::uint32_t> triangles_from(TriangleMode mode, std::vector<std::uint32_t> corners);

/// Gives each triangle its own three vertices with its face's normal, and takes tangents away, as the format asks for
/// where normals are missing.
void make_flat(std::vector<Vertex>& vertices, std::vector<std::uint32_t>& indices);

} // namespace alpenglow::gltf
