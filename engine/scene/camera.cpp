#include "scene/camera.h"

#include "scene/geodesy.h"

#include <cmath>

namespace alpenglow {

glm::dmat3 world_from_camera_angles(double latitude, double longitude, double heading, double pitch, double roll) {
    glm::dmat3 const frame = world_from_east_north_up(latitude, longitude);
    return world_from_camera_ahead(std::sin(heading) * frame[0] + std::cos(heading) * frame[1], frame[2], pitch, roll);
}

glm::dmat3 world_from_camera_ahead(glm::dvec3 const& ahead, glm::dvec3 const& local_up, double pitch, double roll) {
    glm::dvec3 const level_right = glm::cross(ahead, local_up);
    glm::dvec3 const forward = std::cos(pitch) * ahead + std::sin(pitch) * local_up;
    glm::dvec3 const level_up = std::cos(pitch) * local_up - std::sin(pitch) * ahead;
    glm::dvec3 const right = std::cos(roll) * level_right - std::sin(roll) * level_up;
    glm::dvec3 const up = std::cos(roll) * level_up + std::sin(roll) * level_right;
    return {right, up, -forward};
}

CameraAngles camera_angles(glm::dmat3 const& world_from_camera, double latitude, double longitude) {
    // Nearer to the vertical than this [rad], the heading is that of the picture's upper edge, and roll is nothing.
    constexpr double VERTICAL = 1e-9;
    glm::dmat3 const camera = glm::transpose(world_from_east_north_up(latitude, longitude)) * world_from_camera;
    glm::dvec3 const right = camera[0], up = camera[1], forward = -camera[2];
    double const horizontal = std::hypot(forward.x, forward.y);
    double const pitch = std::atan2(forward.z, horizontal);
    if (horizontal < VERTICAL) {
        double const sense = forward.z > 0 ? -1 : 1; // looking up, the upper edge points back
        return {.heading = std::atan2(sense * up.x, sense * up.y), .pitch = pitch, .roll = 0};
    }
    glm::dvec3 const level_right{forward.y / horizontal, -forward.x / horizontal, 0};
    glm::dvec3 const level_up = glm::cross(level_right, forward);
    return {.heading = std::atan2(forward.x, forward.y),
            .pitch = pitch,
            .roll = std::atan2(-glm::dot(right, level_up), glm::dot(right, level_right))};
}

} // namespace alpenglow
