#include "render/terrain_fit.h"

#include <algorithm>

namespace alpenglow {

namespace {

constexpr double LARGEST = 0.25; // of the planet's radius: a scene seen from above as a height field

Box bounds_in(glm::dmat3 const& axes, ShadowScene const& scene) {
    Box box;
    for (int i = 0; i < 8; ++i) box.include(glm::transpose(axes) * scene.corner(i));
    return box;
}

} // namespace

TerrainFit fit_terrain(ShadowScene const& scene, Planet const& planet, int size) {
    TerrainFit fit;
    if (scene.bounds.empty() || size == 0) return fit;
    fit.origin = glm::dvec3(scene.world_from_scene[3]);
    glm::dvec3 const up = glm::normalize(glm::dvec3(scene.world_from_scene[1]));
    glm::dvec3 const x = glm::normalize(glm::dvec3(scene.world_from_scene[0]));
    fit.axes = {x, glm::cross(up, x), up};
    Box const box = bounds_in(fit.axes, scene);
    glm::dvec3 const extent = box.highest - box.lowest;
    double const side = std::max(extent.x, extent.y);
    if (side > LARGEST * planet.radius) return fit;
    fit.size = size;
    fit.texel = side / (size - 2);
    fit.lowest = 0.5 * glm::dvec2(box.lowest + box.highest) - 0.5 * size * fit.texel;
    double const spare = 0.01 * extent.z + 1e-3;
    fit.bottom = box.lowest.z - spare, fit.top = box.highest.z + spare;
    fit.planet_radius = planet.radius;
    return fit;
}

glm::dvec3 middle(TerrainFit const& fit) {
    glm::dvec2 const across = fit.lowest + 0.5 * fit.size * fit.texel;
    return fit.origin + fit.axes * glm::dvec3(across, 0.5 * (fit.bottom + fit.top));
}

glm::mat4 terrain_clip(TerrainFit const& fit) {
    double const scale = 2.0 / (fit.size * fit.texel), depth = 1.0 / (fit.top - fit.bottom);
    glm::dvec2 const middle = fit.lowest + 0.5 * fit.size * fit.texel;
    glm::dmat4 clip(0.0); // from (x, y, z)
    clip[0][0] = scale;
    clip[1][1] = -scale;
    clip[2][2] = depth;
    clip[3] = {-middle.x * scale, middle.y * scale, -fit.bottom * depth, 1.0};
    return glm::mat4(clip * glm::dmat4(glm::transpose(fit.axes)));
}

shader::TerrainMap terrain_constants(TerrainFit const& fit, glm::dvec3 const& camera) {
    auto const f = [](double x) { return static_cast<float>(x); };
    return {glm::vec3(fit.axes[0]), glm::vec3(fit.axes[1]), glm::vec3(fit.axes[2]), glm::vec3(fit.origin - camera),
            glm::vec2(fit.lowest), f(fit.texel), f(fit.bottom), f(fit.top - fit.bottom),
            f(glm::length(fit.origin) - fit.planet_radius), fit.size};
}

} // namespace alpenglow
