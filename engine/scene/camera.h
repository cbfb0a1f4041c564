#pragma once

#include <glm/glm.hpp>

namespace alpenglow {

/// Camera space: right-handed, +X right, +Y up, -Z forward.
struct Camera {
    glm::dvec3 position{0};              ///< world [m]
    glm::dmat3 world_from_camera{1};     ///< rotation; columns right, up, back
    double vertical_fov = 1.0471975512;  ///< [rad]

    glm::dvec3 forward() const { return -world_from_camera[2]; }
};

/// Heading clockwise from north, pitch up positive, roll clockwise as the pilot sees it, all [rad].
glm::dmat3 world_from_camera_angles(double latitude, double longitude, double heading, double pitch, double roll);

} // namespace alpenglow
