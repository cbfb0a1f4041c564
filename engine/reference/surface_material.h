#pragma once

#include "reference/ground_point.h"
#include "scene/scene.h"

#include <array>

namespace alpenglow {

/// A place on a triangle of a mesh.
struct TrianglePlace {
    std::array<Vertex const*, 3> corners{};
    glm::dvec3 weights{1, 0, 0}; ///< of the corners; their sum is 1

    /// The corners' `member`, interpolated.
    template <class Vector> auto mixed(Vector Vertex::*member) const {
        using Result = glm::vec<Vector::length(), double>;
        return weights.x * Result(corners[0]->*member) + weights.y * Result(corners[1]->*member) +
               weights.z * Result(corners[2]->*member);
    }
};

/// A texture's finest level at the place, filtered as for magnification; `srgb` pictures are made linear texel by
/// texel. White where there is no texture.
glm::dvec4 sample_texture(Scene const& scene, Texture const& texture, TrianglePlace const& place, bool srgb);

/// An alpha mask takes the place away.
bool cut_out(Scene const& scene, Material const& material, TrianglePlace const& place);

/// Colour, metalness and roughness from factors, textures and vertex colours. Occlusion is left to the tracer.
GroundSurface surface_at(Scene const& scene, Material const& material, TrianglePlace const& place);
glm::dvec3 emission_at(Scene const& scene, Material const& material, TrianglePlace const& place);

/// The vertex normals' mean in world space, on `facing`'s side, with the normal map over it: by tangents, or where
/// there are none by how the texture lies on the triangle. Unit. `facing`: the triangle's unit normal on the viewer's
/// side, which also stands in where the vertices have no usable normal.
glm::dvec3 shading_normal(Scene const& scene, Material const& material, TrianglePlace const& place,
                          glm::dmat3 const& world_from_mesh, glm::dvec3 const& facing);

} // namespace alpenglow
