#include "render/ceiling_fit.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr int FEWEST_TEXELS = 16;
constexpr double MARGIN = 1.5;      // [texels] of nothing around the scene, so that what lies beside it is lit
constexpr double LARGEST = 0.25;    // of the planet's radius: a scene seen from above as a height field
constexpr double LOWEST_SINE = -0.3; // the planet's shadow is 5 % of its radius high there
constexpr double LONGEST = 1e6;     // [m] of a shadow; behind, the planet shades the air

/// Right angles to the sun as far as it is not straight above.
glm::dmat3 turned_axes(glm::dmat4 const& world_from_scene, glm::dvec3 const& to_sun) {
    glm::dvec3 const up = glm::normalize(glm::dvec3(world_from_scene[1]));
    glm::dvec3 const level = to_sun - up * glm::dot(to_sun, up);
    glm::dvec3 const sunward = glm::normalize(glm::length(level) > 1e-6 ? level : glm::dvec3(world_from_scene[0]));
    return {glm::cross(up, sunward), up, sunward};
}

/// Puts the rectangle around the scene's corners.
void bound_scene(CeilingFit& fit, ShadowScene const& scene) {
    Box box;
    fit.over = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) {
        glm::dvec3 const place = glm::transpose(fit.axes) * scene.corner(i);
        box.include(place);
        fit.over = std::max(fit.over, place.y * fit.sun.x - place.z * fit.sun.y);
    }
    fit.lowest = {box.lowest.x, box.lowest.z}, fit.highest = {box.highest.x, box.highest.z};
    double const spare = 0.01 * (box.highest.y - box.lowest.y) + 1e-3;
    fit.bottom = box.lowest.y - spare, fit.top = box.highest.y + spare;
}

/// A shadow sinks from its caster on, and rises again where the planet has turned away below it: above the caster
/// where the ray doesn't meet the ground before.
double shaded_altitude(CeilingFit const& fit, double highest) {
    double const reach = std::max(glm::length(fit.lowest), glm::length(fit.highest));
    double const elevation = std::atan2(fit.sun.y, fit.sun.x) - reach / fit.planet_radius;
    bool const rises = (fit.planet_radius + highest) * std::cos(std::max(elevation, 0.0)) > fit.planet_radius;
    return rises ? fit.planet_radius : highest + 10.0;
}

glm::dvec3 over_axis(CeilingFit const& fit) { return fit.axes[1] * fit.sun.x - fit.axes[2] * fit.sun.y; }

} // namespace

CeilingFit fit_ceiling(ShadowScene const& scene, double highest, Planet const& planet, glm::dvec3 const& to_sun,
                       int size) {
    CeilingFit fit;
    fit.planet_radius = planet.radius;
    fit.sun_angular_radius = planet.sun_angular_radius;
    fit.origin = glm::dvec3(scene.world_from_scene[3]);
    fit.axes = turned_axes(scene.world_from_scene, to_sun);
    fit.sun = {std::max(glm::dot(to_sun, fit.axes[2]), 0.0), glm::dot(to_sun, fit.axes[1])};
    if (scene.bounds.empty()) return fit;
    bound_scene(fit, scene);
    fit.shaded_altitude = shaded_altitude(fit, highest);
    bool const useful = glm::distance(fit.lowest, fit.highest) < LARGEST * planet.radius && fit.sun.y > LOWEST_SINE;
    if (size == 0 || !useful) return fit;
    fit.size = std::max(size, FEWEST_TEXELS);
    glm::dvec2 const margin = MARGIN * glm::max(fit.highest - fit.lowest, 1e-3) / (fit.size - 2 * MARGIN);
    fit.lowest -= margin, fit.highest += margin;
    return fit;
}

glm::mat4 ceiling_clip(CeilingFit const& fit) {
    glm::dvec2 const scale = 2.0 / (fit.highest - fit.lowest), middle = 0.5 * (fit.highest + fit.lowest);
    double const depth = 1.0 / (fit.top - fit.bottom);
    glm::dmat4 clip(0.0); // from (across, up, towards the sun)
    clip[0][0] = scale.x;
    clip[1][2] = -depth;
    clip[2][1] = -scale.y;
    clip[3] = {-middle.x * scale.x, middle.y * scale.y, fit.top * depth, 1.0};
    return glm::mat4(clip * glm::dmat4(glm::transpose(fit.axes)));
}

shader::ShadowCeilingPush ceiling_push(CeilingFit const& fit) {
    auto const f = [](double x) { return static_cast<float>(x); };
    double const texel = fit.texel().y;
    return {glm::vec2(fit.sun), f(fit.top), f(fit.top - fit.bottom), f(fit.highest.y - 0.5 * texel), f(texel)};
}

shader::ShadowCeiling ceiling_constants(CeilingFit const& fit, glm::dmat3 const& light_from_world,
                                        glm::dvec3 const& camera) {
    shader::ShadowCeiling ceiling{};
    glm::dvec3 const over = over_axis(fit), along = fit.axes[2] * fit.sun.x + fit.axes[1] * fit.sun.y;
    glm::dvec3 const place = camera - fit.origin;
    ceiling.light_across = glm::vec2(light_from_world * fit.axes[0]);
    ceiling.light_over = glm::vec2(light_from_world * over);
    ceiling.camera = glm::vec3(glm::dot(fit.axes[0], place), glm::dot(over, place), glm::dot(along, place));
    ceiling.sun = glm::vec2(fit.sun);
    ceiling.sun_tangent = static_cast<float>(std::max(std::tan(fit.sun_angular_radius), 1e-6));
    ceiling.deepest = static_cast<float>(fit.planet_radius);
    ceiling.texel = 1; // without a map, any
    if (fit.size == 0) return ceiling;
    glm::dvec2 const scale = glm::dvec2(1, -1) / (fit.highest - fit.lowest);
    ceiling.scale = glm::vec2(scale);
    ceiling.offset = glm::vec2(-fit.lowest.x * scale.x, -fit.highest.y * scale.y);
    ceiling.texel = static_cast<float>(std::max(fit.texel().x, fit.texel().y));
    ceiling.texel_v = 1.0f / static_cast<float>(fit.size);
    return ceiling;
}

void set_shaded_slabs(shader::FrameConstants& frame, CeilingFit const& fit) {
    shader::Cascade const& last = frame.cascades[MOST_CASCADES - 1];
    frame.shaded_slabs[0] = {last.scale, 0, 0, last.offset.x};
    frame.shaded_slabs[1] = {0, last.scale, 0, last.offset.y};
    frame.shaded_slabs[2] = {0, 0, 0, 0.5f};
    if (fit.size == 0) return;
    shader::ShadowCeiling const& c = frame.ceiling;
    float const reach = static_cast<float>(1.0 / LONGEST);
    frame.shaded_slabs[0] = glm::vec4(c.light_across * c.scale.x, 0, c.camera.x * c.scale.x + c.offset.x);
    // u = along cos - over sin; from the sunward edge to LONGEST behind it.
    float const u = c.camera.z * c.sun.x - c.camera.y * c.sun.y;
    frame.shaded_slabs[1] = glm::vec4(c.light_over * c.sun.y, c.sun.x, static_cast<float>(fit.highest.y) - u) * reach;
    frame.shaded_slabs[2] = glm::vec4(-c.light_over, 0, static_cast<float>(fit.over) - c.camera.y) * reach;
}

} // namespace alpenglow
