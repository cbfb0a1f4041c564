#pragma once

#include "scene/view.h"

namespace alpenglow {

/// What the user asks for during one step.
struct FlyInput {
    glm::dvec3 move{0};                  ///< right, up, forward in camera axes, each -1 to 1
    double yaw = 0, pitch = 0, roll = 0; ///< [rad] turns of this step: clockwise from above, upwards, clockwise
    double boost = 1;                    ///< multiplies the speed
};

/// A free camera over a planet. Its heading is kept as a direction along the ground and carried along the great circle
/// that it flies, so that nothing turns by itself at the poles or when looking straight down.
class FlyCamera {
public:
    FlyCamera(CameraPlace const& place, double planet_radius);

    /// `dt` in [s]; `ground_altitude` [m] is that of the ground below. Speed is half the height above it each second,
    /// at least 2 m/s. The camera stays at least 1 m above the ground and below 1e9 m.
    void advance(double dt, FlyInput const& input, double ground_altitude = 0);

    Camera camera() const;
    /// For a view file.
    CameraPlace place() const;
    double altitude() const;                                   ///< [m] above the reference radius
    double speed(double ground_altitude = 0) const;            ///< [m/s] without boost
    void set_vertical_fov(double fov) { vertical_fov_ = fov; } ///< [rad]

private:
    glm::dvec3 up() const { return glm::normalize(position_); }
    void turn(FlyInput const& input);
    void travel(glm::dvec3 const& way, double lowest);

    double radius_;
    glm::dvec3 position_; ///< world [m]
    glm::dvec3 ahead_;    ///< unit, level: the heading
    double pitch_, roll_; ///< [rad]
    double vertical_fov_; ///< [rad]
};

} // namespace alpenglow
