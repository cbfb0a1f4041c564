#include "scene/studio.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

constexpr double SIZE = 10;      // [m] from the centre to a corner of every scene
constexpr double BOARD = 0.1;    // depth of what is seen from its front, of the largest extent
constexpr double FLAT = 1e-3;    // what is this thin is seen along its thin axis; a terrain is not
constexpr double FILLED = 0.92;  // of the picture's height or width
constexpr double FIELD_OF_VIEW = 0.5; // [rad]
constexpr double KEY = 0.7, FILL = 1 - KEY; // irradiance: a white surface that faces the key light shows white
constexpr double BACKDROP = 0.1; // displayed, linear; darker than most things
glm::dvec3 const TO_KEY(-0.25, 0.65, 0.75); // in the camera's frame

/// Columns right, up, back.
glm::dmat3 scene_from_camera(glm::dvec3 const& extent) {
    double const largest = std::max({extent.x, extent.y, extent.z});
    glm::dvec3 back(0.5, 0.4, 1), up(0, 1, 0);
    if (extent.z <= BOARD * largest)
        back = {0, 0, 1};
    else if (extent.y <= FLAT * largest)
        back = {0, 1, 0}, up = {0, 0, -1};
    else if (extent.x <= FLAT * largest)
        back = {1, 0, 0};
    back = glm::normalize(back);
    glm::dvec3 const right = glm::normalize(glm::cross(up, back));
    return {right, glm::cross(back, right), back};
}

/// How far from the box's centre all its corners are in the picture; half extents in the scene's axes.
double framing_distance(glm::dvec3 const& half, glm::dmat3 const& axes, double aspect) {
    double const slope_y = FILLED * std::tan(0.5 * FIELD_OF_VIEW), slope_x = slope_y * aspect;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        glm::dvec3 const corner = half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        glm::dvec3 const q = glm::transpose(axes) * corner;
        distance = std::max(distance, q.z + std::max(std::abs(q.x) / slope_x, std::abs(q.y) / slope_y));
    }
    return distance;
}

Planet sun_alone() {
    Planet planet;
    planet.name = "studio";
    planet.has_air = false;
    planet.look = GroundLook::uniform;
    planet.solar_irradiance = glm::dvec3(KEY);
    return planet;
}

} // namespace

StudioShot make_studio_shot(Box const& bounds, double aspect) {
    glm::dvec3 const half = 0.5 * (bounds.highest - bounds.lowest);
    StudioShot shot{.placement = {}, .world = {.planet = sun_alone(), .camera = {}}};
    // A point keeps its size; beyond the limits a float matrix would overflow.
    double const radius = glm::length(half);
    shot.placement.scale = radius > 0 ? std::clamp(SIZE / radius, 1e-20, 1e20) : 1;

    glm::dmat4 const world_from_scene = alpenglow::world_from_scene(shot.placement, shot.world.planet.radius);
    glm::dmat3 const axes = scene_from_camera(2.0 * half);
    double const distance = radius > 0 ? framing_distance(half, axes, aspect) : SIZE;
    glm::dvec3 const eye = bounds.centre() + axes[2] * distance;

    Camera& camera = shot.world.camera;
    camera.position = glm::dvec3(world_from_scene * glm::dvec4(eye, 1));
    camera.world_from_camera = glm::dmat3(world_from_scene) / shot.placement.scale * axes;
    camera.vertical_fov = FIELD_OF_VIEW;
    shot.world.to_sun = camera.world_from_camera * glm::normalize(TO_KEY);
    shot.world.studio = Studio{.fill = glm::dvec3(FILL / KEY), .backdrop = glm::dvec3(BACKDROP / std::numbers::pi)};
    return shot;
}

Settings studio_settings() {
    Settings settings;
    settings.air = settings.sun_disc = false;
    settings.shafts = "off";
    settings.exposure = std::log2(std::numbers::pi); // a Lambert surface sends back its albedo over pi
    settings.curve = "linear";
    settings.dither = false; // there is nothing smooth and dark to band, and flat ground packs well
    settings.aa = 16;
    settings.cascades = 1;
    return settings;
}

} // namespace alpenglow
