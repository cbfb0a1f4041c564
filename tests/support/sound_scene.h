#pragma once

#include "scene/scene.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

namespace alpenglow::test {

/// What is wrong with a loaded scene: an index out of its range, a number that is not finite. "" for a sound one, which
/// every renderer may take without a check of its own.
std::string fault_of(Scene const& scene);

namespace detail {

inline bool all_finite(std::span<float const> numbers) {
    return std::ranges::all_of(numbers, [](float x) { return std::isfinite(x); });
}

template <class Matrix> bool is_finite(Matrix const& matrix) {
    auto const* const first = glm::value_ptr(matrix);
    return std::all_of(first, first + sizeof(Matrix) / sizeof *first, [](auto x) { return std::isfinite(x); });
}

inline bool is_finite(Box const& box) {
    return is_finite(box.lowest) && is_finite(box.highest) && !box.empty();
}

inline std::string fault_of(Mesh const& mesh, std::size_t materials) {
    static_assert(sizeof(Vertex) == 18 * sizeof(float));
    for (Vertex const& vertex : mesh.vertices)
        if (!all_finite({&vertex.position.x, 18})) return "a vertex that is not finite";
    if (std::ranges::any_of(mesh.indices, [&](std::uint32_t index) { return index >= mesh.vertices.size(); }))
        return "an index without a vertex";
    for (MeshPart const& part : mesh.parts) {
        if (part.index_count == 0 || part.index_count % 3 != 0) return "a part that is not of whole triangles";
        if (std::uint64_t{part.first_index} + part.index_count > mesh.indices.size()) return "a part beyond the indices";
        if (part.material >= materials) return "a part without a material";
        if (!is_finite(part.bounds)) return "a part whose box is not finite";
    }
    return "";
}

inline std::string fault_of(Material const& material, std::size_t pictures) {
    if (!is_finite(material.base_color) || !is_finite(material.emission)) return "a colour that is not finite";
    if (!all_finite(std::to_array({material.metallic, material.roughness, material.normal_scale,
                                   material.occlusion_strength, material.alpha_cutoff, material.specular,
                                   material.reflectance})))
        return "a factor that is not finite";
    for (Texture const* const texture :
         {&material.base_color_texture, &material.metallic_roughness_texture, &material.normal_texture,
          &material.occlusion_texture, &material.emission_texture}) {
        if (*texture && texture->picture >= pictures) return "a texture without a picture";
        if (texture->uv_set > 1) return "a texture with a third set of coordinates";
        if (!all_finite({&texture->uv_from_vertex[0][0], 6})) return "a texture transform that is not finite";
    }
    return "";
}

} // namespace detail

inline std::string fault_of(Scene const& scene) {
    for (Mesh const& mesh : scene.meshes)
        if (std::string const fault = detail::fault_of(mesh, scene.materials.size()); !fault.empty()) return fault;
    for (Material const& material : scene.materials)
        if (std::string const fault = detail::fault_of(material, scene.pictures.size()); !fault.empty()) return fault;
    for (Picture const& picture : scene.pictures) {
        if (picture.width == 0 || picture.height == 0) return "an empty picture";
        if (picture.rgba.size() != std::size_t{4} * picture.width * picture.height) return "a picture of another size";
    }
    for (Instance const& instance : scene.instances) {
        if (instance.mesh >= scene.meshes.size()) return "an instance without a mesh";
        if (!detail::is_finite(instance.scene_from_mesh)) return "an instance whose place is not finite";
    }
    for (SceneCamera const& camera : scene.cameras)
        if (!detail::is_finite(camera.scene_from_camera)) return "a camera whose place is not finite";
    if (!scene.instances.empty() && !detail::is_finite(scene.bounds)) return "bounds that are not finite";
    return "";
}

} // namespace alpenglow::test
