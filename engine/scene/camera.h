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

/// The same from the direction of the heading: `ahead` and `local_up` are unit vectors at a right angle.
glm::dmat3 world_from_camera_ahead(glm::dvec3 const& ahead, glm::dvec3 const& local_up, double pitch, double roll);

/// All [rad]. Heading and roll in -pi to pi, pitch in -pi/2 to pi/2.
struct CameraAngles {
    double heading = 0, pitch = 0, roll = 0;
};

/// The inverse of world_from_camera_angles. Straight up or down, where heading and roll are one, roll is 0.
CameraAngles camera_angles(glm::dmat3 const& world_from_camera, double latitude, double longitude);

} // namespace alpenglow
