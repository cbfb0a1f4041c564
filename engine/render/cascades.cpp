#include "render/cascades.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double AHEAD = 0.5;         // of the half width, from the focus along the view
constexpr double LARGEST_RATIO = 6.0; // of one cascade's width to the next: texels of 0.4 m near and 65 m far at 100 km
constexpr double SIZE_STEP = 1.189207; // 2^(1/4): sizes are rounded up to powers of it, so that they rarely change

double rounded_up(double size) { return std::pow(SIZE_STEP, std::ceil(std::log(size) / std::log(SIZE_STEP) - 1e-9)); }

} // namespace

glm::dvec3 ShadowScene::corner(int i) const {
    return glm::dmat3(world_from_scene) * glm::dvec3(i & 1 ? bounds.highest.x : bounds.lowest.x,
                                                     i & 2 ? bounds.highest.y : bounds.lowest.y,
                                                     i & 4 ? bounds.highest.z : bounds.lowest.z);
}

glm::dmat3 light_from_world(glm::dvec3 const& to_sun, glm::dmat3 const& axes) {
    glm::dvec3 const z = -to_sun;
    glm::dvec3 const pole = std::abs(glm::dot(z, axes[2])) < 0.99 ? axes[2] : axes[0];
    glm::dvec3 const x = glm::normalize(glm::cross(pole, z));
    return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

ShadowFit fit_cascades(ShadowScene const& scene, Camera const& camera, glm::dvec3 const& to_sun,
                       ShadowSettings const& settings) {
    ShadowFit fit;
    glm::dmat3 const axes(scene.world_from_scene);
    fit.light_from_world =
        light_from_world(to_sun, {glm::normalize(axes[0]), glm::normalize(axes[1]), glm::normalize(axes[2])});
    if (scene.bounds.empty()) return fit;

    fit.nearest = std::numeric_limits<double>::infinity(), fit.farthest = -fit.nearest;
    for (int i = 0; i < 8; ++i) {
        double const z =
            (fit.light_from_world * (glm::dvec3(scene.world_from_scene[3]) + scene.corner(i))).z;
        fit.nearest = std::min(fit.nearest, z), fit.farthest = std::max(fit.farthest, z);
    }
    double const margin = 0.01 * (fit.farthest - fit.nearest) + 1e-3;
    fit.nearest -= margin, fit.farthest += margin;

    glm::dvec3 const camera_in_scene(glm::inverse(scene.world_from_scene) * glm::dvec4(camera.position, 1.0));
    glm::dvec3 const nearest = glm::clamp(camera_in_scene, scene.bounds.lowest, scene.bounds.highest);
    glm::dvec3 const focus(scene.world_from_scene * glm::dvec4(nearest, 1.0));
    double const distance = glm::distance(focus, camera.position);
    double const diagonal =
        glm::length(glm::dmat3(scene.world_from_scene) * (scene.bounds.highest - scene.bounds.lowest));

    double const coarsest = rounded_up(std::min(settings.reach, diagonal) / (1.0 + AHEAD));
    // Finer than this a texel would be far below a pixel.
    double const useful = rounded_up(std::max(0.6 * distance * std::tan(0.5 * camera.vertical_fov), 1e-6));
    glm::dvec2 const origin(fit.light_from_world * glm::dvec3(scene.world_from_scene[3]));
    int const steps = settings.cascades - 1;
    double const finest = std::clamp(useful, coarsest / std::pow(LARGEST_RATIO, steps), coarsest);
    bool const one_is_enough = steps == 0 || finest > 0.95 * coarsest;
    double const ratio = one_is_enough ? 1.0 : std::pow(coarsest / finest, 1.0 / steps);
    for (int i = one_is_enough ? steps : 0; i <= steps; ++i) {
        CascadeFit cascade;
        cascade.half_width = coarsest / std::pow(ratio, steps - i);
        cascade.texel = 2.0 * cascade.half_width / settings.size;
        glm::dvec2 const wanted(fit.light_from_world * (focus + AHEAD * cascade.half_width * camera.forward()));
        cascade.centre = origin + glm::round((wanted - origin) / cascade.texel) * cascade.texel;
        fit.cascades.push_back(cascade);
    }
    return fit;
}

bool touches(CascadeFit const& cascade, glm::dmat3 const& light, Sphere const& sphere) {
    glm::dvec2 const offset = glm::abs(glm::dvec2(light * sphere.centre) - cascade.centre);
    return std::max(offset.x, offset.y) <= cascade.half_width + sphere.radius;
}

bool in_view(Camera const& camera, double aspect, Sphere const& sphere) {
    glm::dvec3 const p = glm::transpose(camera.world_from_camera) * (sphere.centre - camera.position);
    double const ty = std::tan(0.5 * camera.vertical_fov), tx = ty * aspect;
    // Signed distance outside a side of the view, whose normal leans back by the side's slope.
    auto const outside = [&](double across, double slope) {
        return (std::abs(across) + p.z * slope) / std::sqrt(1.0 + slope * slope);
    };
    return p.z <= sphere.radius && outside(p.x, tx) <= sphere.radius && outside(p.y, ty) <= sphere.radius;
}

} // namespace alpenglow
