#include "scene/fly_camera.h"

#include "scene/file_keys.h"
#include "scene/interpolation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

constexpr double SLOWEST = 2;         // [m/s]
constexpr double HEIGHTS_A_SECOND = 0.5;
constexpr double LOWEST = 1;          // [m] above the ground

} // namespace

FlyCamera::FlyCamera(CameraPlace const& place, double planet_radius)
    : radius_(planet_radius), position_(world_from_geodetic(place.place, planet_radius)), pitch_(place.pitch),
      roll_(place.roll), vertical_fov_(place.vertical_fov) {
    glm::dmat3 const frame = world_from_east_north_up(place.place.latitude, place.place.longitude);
    ahead_ = std::sin(place.heading) * frame[0] + std::cos(place.heading) * frame[1];
}

double FlyCamera::altitude() const { return geodetic_from_world(position_, radius_).altitude; }

double FlyCamera::speed(double ground_altitude) const {
    return std::max(SLOWEST, HEIGHTS_A_SECOND * (altitude() - ground_altitude));
}

Camera FlyCamera::camera() const {
    return {.position = position_,
            .world_from_camera = world_from_camera_ahead(ahead_, up(), pitch_, roll_),
            .vertical_fov = vertical_fov_};
}

CameraPlace FlyCamera::place() const {
    Geodetic const place = geodetic_from_world(position_, radius_);
    glm::dvec3 const local = glm::transpose(world_from_east_north_up(place.latitude, place.longitude)) * ahead_;
    return {.place = place,
            .heading = std::atan2(local.x, local.y),
            .pitch = pitch_,
            .roll = roll_,
            .vertical_fov = vertical_fov_};
}

void FlyCamera::advance(double dt, FlyInput const& input, double ground_altitude) {
    turn(input);
    glm::dmat3 const axes = camera().world_from_camera;
    glm::dvec3 const direction = input.move.x * axes[0] + input.move.y * axes[1] - input.move.z * axes[2];
    travel(dt * input.boost * speed(ground_altitude) * direction, ground_altitude + LOWEST);
}

void FlyCamera::turn(FlyInput const& input) {
    glm::dvec3 const right = glm::cross(ahead_, up());
    ahead_ = glm::normalize(std::cos(input.yaw) * ahead_ + std::sin(input.yaw) * right);
    constexpr double STRAIGHT = std::numbers::pi / 2;
    pitch_ = std::clamp(pitch_ + input.pitch, -STRAIGHT, STRAIGHT);
    roll_ = std::remainder(roll_ + input.roll, 2 * std::numbers::pi);
}

void FlyCamera::travel(glm::dvec3 const& way, double lowest) {
    glm::dvec3 const old_up = up();
    position_ += way;
    double const altitude_now = std::clamp(altitude(), lowest, json::CAMERA_ALTITUDE.largest);
    glm::dvec3 const new_up = up();
    if (altitude_now != altitude()) position_ = (radius_ + altitude_now) * new_up;
    glm::dvec3 const carried = interpolation::carry(ahead_, old_up, new_up);
    ahead_ = glm::normalize(carried - glm::dot(carried, new_up) * new_up);
}

} // namespace alpenglow
