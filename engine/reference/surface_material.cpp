#include "reference/surface_material.h"

#include "reference/surface_scattering.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace alpenglow {

namespace {

double linear_from_srgb(double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

std::array<double, 256> const& linear_from_byte() {
    static auto const table = [] {
        std::array<double, 256> values{};
        for (int i = 0; i < 256; ++i) values[i] = linear_from_srgb(i / 255.0);
        return values;
    }();
    return table;
}

/// The texel that stands for number `i` of a row or column of `size`.
std::int64_t wrapped(std::int64_t i, std::int64_t size, TextureWrap wrap) {
    if (wrap == TextureWrap::clamp) return std::clamp<std::int64_t>(i, 0, size - 1);
    std::int64_t const period = wrap == TextureWrap::mirror ? 2 * size : size;
    std::int64_t const within = (i % period + period) % period;
    return within < size ? within : period - 1 - within;
}

double channel(Picture const& picture, std::size_t index, bool srgb) {
    if (picture.deep()) {
        double const stored = picture.rgba16[index] / 65535.0;
        return srgb ? linear_from_srgb(stored) : stored;
    }
    return srgb ? linear_from_byte()[picture.rgba[index]] : picture.rgba[index] / 255.0;
}

glm::dvec4 texel(Picture const& picture, Texture const& texture, glm::i64vec2 const& at, bool srgb) {
    std::int64_t const x = wrapped(at.x, picture.width, texture.wrap_u);
    std::int64_t const y = wrapped(at.y, picture.height, texture.wrap_v);
    auto const first = static_cast<std::size_t>(4 * (y * picture.width + x));
    glm::dvec4 value;
    for (int i = 0; i < 4; ++i) value[i] = channel(picture, first + static_cast<std::size_t>(i), srgb && i < 3);
    return value;
}

/// Texels from the first one's corner; 0 for broken coordinates and those too far off to be placed within a texel.
glm::dvec2 texels_from_uv(Picture const& picture, glm::dvec2 const& uv) {
    constexpr double FARTHEST = 1e9;
    bool const usable = std::abs(uv.x) < FARTHEST && std::abs(uv.y) < FARTHEST;
    return usable ? uv * glm::dvec2(picture.width, picture.height) : glm::dvec2(0);
}

glm::dvec2 uv_at(Texture const& texture, TrianglePlace const& place) {
    glm::dvec2 const own = place.mixed(texture.uv_set != 0 ? &Vertex::uv1 : &Vertex::uv0);
    return glm::dmat3x2(texture.uv_from_vertex) * glm::dvec3(own, 1);
}

glm::dvec4 base_color_at(Scene const& scene, Material const& material, TrianglePlace const& place) {
    return glm::dvec4(material.base_color) * place.mixed(&Vertex::color) *
           sample_texture(scene, material.base_color_texture, place, true);
}

/// Of a dielectric at normal incidence.
double reflectance_at(Scene const& scene, Material const& material, TrianglePlace const& place) {
    double share = 1;
    if (material.reflectance_texture)
        share = glm::dot(glm::dvec3(material.reflectance_shares),
                         glm::dvec3(sample_texture(scene, material.reflectance_texture, place, true)));
    return std::min(material.reflectance * share, double{Material::largest_reflectance});
}

/// `v` as a unit vector, or `otherwise` where it has no direction.
glm::dvec3 unit_or(glm::dvec3 const& v, glm::dvec3 const& otherwise) {
    double const length = glm::length(v);
    return length > 1e-30 && std::isfinite(length) ? v / length : otherwise;
}

/// Normals of a mesh that is scaled or mirrored go by the cofactor matrix.
glm::dvec3 vertex_normal(TrianglePlace const& place, glm::dmat3 const& m, glm::dvec3 const& facing) {
    glm::dmat3 const cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    glm::dvec3 sum(0);
    for (int i = 0; i < 3; ++i) {
        sum += place.weights[i] * unit_or(cofactor * glm::dvec3(place.corners[i]->normal), glm::dvec3(0));
    }
    glm::dvec3 const normal = unit_or(sum, facing);
    return glm::dot(normal, facing) < 0 ? -normal : normal;
}

/// Columns: the normal map's axes and `n`, from the triangle's edges and their texture coordinates (Schueler 2013,
/// "Followup: Normal Mapping Without Precomputed Tangents"). The second axis points to decreasing v, up in the picture.
glm::dmat3 frame_from_edges(TrianglePlace const& place, Texture const& texture, glm::dmat3 const& world_from_mesh,
                            glm::dvec3 const& n) {
    std::array<glm::dvec3, 2> edges;
    std::array<glm::dvec2, 2> uv_edges;
    auto const uv = texture.uv_set != 0 ? &Vertex::uv1 : &Vertex::uv0;
    for (std::size_t i = 0; i < 2; ++i) {
        Vertex const &first = *place.corners[0], &other = *place.corners[i + 1];
        edges[i] = world_from_mesh * (glm::dvec3(other.position) - glm::dvec3(first.position));
        uv_edges[i] = glm::dmat2(texture.uv_from_vertex) * (glm::dvec2(other.*uv) - glm::dvec2(first.*uv));
    }
    double const handed = glm::dot(glm::cross(edges[0], edges[1]), n) >= 0 ? 1 : -1;
    glm::dvec3 const across_second = glm::cross(edges[1], n), across_first = glm::cross(n, edges[0]);
    glm::dvec3 const t = (across_second * uv_edges[0].x + across_first * uv_edges[1].x) * handed;
    glm::dvec3 const b = (across_second * uv_edges[0].y + across_first * uv_edges[1].y) * -handed;
    double const longest = std::sqrt(std::max(glm::dot(t, t), glm::dot(b, b)));
    double const scale = longest > 0 && std::isfinite(longest) ? 1 / longest : 0;
    return {t * scale, b * scale, n};
}

glm::dmat3 frame_from_tangent(glm::dvec4 const& tangent, glm::dmat3 const& world_from_mesh, glm::dvec3 const& n) {
    glm::dvec3 const along = world_from_mesh * glm::dvec3(tangent);
    glm::dvec3 const t = unit_or(along - n * glm::dot(n, along), glm::dvec3(0));
    return {t, glm::cross(n, t) * (tangent.w < 0 ? -1.0 : 1.0), n};
}

} // namespace

glm::dvec4 sample_texture(Scene const& scene, Texture const& texture, TrianglePlace const& place, bool srgb) {
    if (!texture) return glm::dvec4(1);
    Picture const& picture = scene.pictures[texture.picture];
    if (picture.bytes() == 0) return glm::dvec4(1);
    glm::dvec2 const at = texels_from_uv(picture, uv_at(texture, place));
    if (texture.magnify == TextureFilter::nearest) return texel(picture, texture, glm::i64vec2(glm::floor(at)), srgb);
    glm::dvec2 const corner = glm::floor(at - 0.5), share = at - 0.5 - corner;
    auto const fetch = [&](int x, int y) {
        return texel(picture, texture, glm::i64vec2(corner) + glm::i64vec2(x, y), srgb);
    };
    return glm::mix(glm::mix(fetch(0, 0), fetch(1, 0), share.x), glm::mix(fetch(0, 1), fetch(1, 1), share.x), share.y);
}

bool cut_out(Scene const& scene, Material const& material, TrianglePlace const& place) {
    return material.alpha_mask && base_color_at(scene, material, place).a < material.alpha_cutoff;
}

GroundSurface surface_at(Scene const& scene, Material const& material, TrianglePlace const& place) {
    if (material.unlit) return make_ground_surface(glm::dvec3(0), 0, 1, 0);
    glm::dvec3 const color = glm::clamp(glm::dvec3(base_color_at(scene, material, place)), 0.0, 1.0);
    glm::dvec4 const texture = sample_texture(scene, material.metallic_roughness_texture, place, false);
    double const metalness = std::clamp(material.metallic * texture.b, 0.0, 1.0);
    double const roughness = std::clamp(material.roughness * texture.g, 0.0, 1.0);
    double const specular = material.specular * sample_texture(scene, material.specular_texture, place, false).a;
    double const gloss = glm::mix<double>(specular, 1, metalness);
    return make_ground_surface(color, metalness, roughness, gloss, reflectance_at(scene, material, place));
}

glm::dvec3 emission_at(Scene const& scene, Material const& material, TrianglePlace const& place) {
    if (material.unlit) return glm::dvec3(base_color_at(scene, material, place)) / std::numbers::pi;
    if (material.emission == glm::vec3(0)) return glm::dvec3(0);
    return glm::dvec3(material.emission) * glm::dvec3(sample_texture(scene, material.emission_texture, place, true));
}

glm::dvec3 shading_normal(Scene const& scene, Material const& material, TrianglePlace const& place,
                          glm::dmat3 const& world_from_mesh, glm::dvec3 const& facing) {
    glm::dvec3 const n = vertex_normal(place, world_from_mesh, facing);
    Texture const& map = material.normal_texture;
    if (!map) return n;
    glm::dvec3 bump = glm::dvec3(sample_texture(scene, map, place, false)) * 2.0 - 1.0;
    bump.x *= material.normal_scale, bump.y *= material.normal_scale;
    glm::dvec4 const tangent = place.mixed(&Vertex::tangent);
    bool const given = std::abs(tangent.w) > 0.5;
    glm::dmat3 const world_from_bump =
        given ? frame_from_tangent(tangent, world_from_mesh, n) : frame_from_edges(place, map, world_from_mesh, n);
    return unit_or(world_from_bump * bump, n);
}

} // namespace alpenglow
