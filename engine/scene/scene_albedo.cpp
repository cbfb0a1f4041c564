#include "scene/scene_albedo.h"

#include "image/color.h"

#include <algorithm>

namespace alpenglow {

namespace {

/// Of every `STRIDE`th texel of every such row.
constexpr std::size_t STRIDE = 7;

glm::vec3 mean_color(Picture const& picture) {
    glm::dvec3 sum(0);
    std::size_t count = 0;
    auto const value = [&](std::size_t i) {
        return picture.deep() ? linear_from_srgb_word(picture.rgba16[i]) : linear_from_srgb_byte(picture.rgba[i]);
    };
    for (std::size_t y = 0; y < picture.height; y += STRIDE) {
        for (std::size_t x = 0; x < picture.width; x += STRIDE, ++count) {
            std::size_t const i = 4 * (y * picture.width + x);
            for (std::size_t c = 0; c < 3; ++c) sum[static_cast<int>(c)] += value(i + c);
        }
    }
    return glm::vec3(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

std::vector<glm::vec3> mean_base_colors(Scene const& scene) {
    std::vector<glm::vec3> colors;
    for (Material const& material : scene.materials) {
        Texture const& texture = material.base_color_texture;
        glm::vec3 const mean = texture ? mean_color(scene.pictures[texture.picture]) : glm::vec3(1);
        colors.push_back(glm::vec3(material.base_color) * mean);
    }
    return colors;
}

struct AreaColor {
    glm::dvec3 color{0}; ///< times the area
    double area = 0;     ///< [m^2] on the map
};

AreaColor outline_of(Mesh const& mesh, MeshPart const& part, glm::dmat4 const& scene_from_mesh) {
    AreaColor sum;
    double const side = glm::determinant(scene_from_mesh) < 0 ? -0.5 : 0.5; // a mirrored mesh shows its fronts the other way
    glm::dvec3 const x(scene_from_mesh[0][0], scene_from_mesh[1][0], scene_from_mesh[2][0]);
    glm::dvec3 const z(scene_from_mesh[0][2], scene_from_mesh[1][2], scene_from_mesh[2][2]);
    for (std::size_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
        Vertex const* const v[3] = {&mesh.vertices[mesh.indices[i]], &mesh.vertices[mesh.indices[i + 1]],
                                    &mesh.vertices[mesh.indices[i + 2]]};
        glm::dvec3 const a(v[1]->position - v[0]->position), b(v[2]->position - v[0]->position);
        double const area = std::max(side * (glm::dot(z, a) * glm::dot(x, b) - glm::dot(x, a) * glm::dot(z, b)), 0.0);
        sum.color += area * glm::dvec3(v[0]->color + v[1]->color + v[2]->color) / 3.0;
        sum.area += area;
    }
    return sum;
}

} // namespace

glm::vec3 albedo_from_above(Scene const& scene) {
    std::vector<glm::vec3> const colors = mean_base_colors(scene);
    AreaColor sum;
    for (Instance const& instance : scene.instances) {
        Mesh const& mesh = scene.meshes[instance.mesh];
        for (MeshPart const& part : mesh.parts) {
            AreaColor const outline = outline_of(mesh, part, instance.scene_from_mesh);
            sum.color += outline.color * glm::dvec3(colors[part.material]);
            sum.area += outline.area;
        }
    }
    return sum.area > 0 ? glm::clamp(glm::vec3(sum.color / sum.area), 0.0f, 1.0f) : glm::vec3(0);
}

} // namespace alpenglow
