#include "sandbox/pilot.h"

#include <algorithm>

namespace alpenglow {

namespace {

/// FlyCamera keeps 1 m from what it takes for the ground; eyes are higher.
constexpr double EYES = 1;                       // [m]
constexpr double LONGEST_STEP = 0.25;            // [s] a slow frame does not throw the camera over the next ridge
constexpr double NARROWEST = 0.02, WIDEST = 2.1; // [rad]

} // namespace

Pilot::Pilot(Stage& stage, Flight flight)
    : stage_(stage), flight_(std::move(flight)), view_(stage.dressed(flight_.at(0))) {}

void Pilot::take_over() {
    if (user_flies()) return;
    camera_.emplace(view_.camera, planet_radius());
    Geodetic const anchor = sun_anchor(view_);
    sun_.emplace(sun_direction(view_.sun, anchor.latitude, anchor.longitude), anchor.longitude);
}

void Pilot::advance(double dt, FlyInput const& input) {
    if (user_flies()) {
        fly(std::min(dt, LONGEST_STEP), input);
        return;
    }
    time_ = std::min(time_ + dt, flight_.duration());
    view_ = stage_.dressed(flight_.at(time_));
}

void Pilot::fly(double dt, FlyInput const& input) {
    camera_->advance(dt, input, lowest());
    camera_->advance(0, {}, lowest()); // out of the slope that the step may have ended in
    view_.camera = camera_->place();
    place_sun();
}

void Pilot::add_sun_hours(double hours) {
    if (!sun_) return;
    sun_->add_hours(hours);
    place_sun();
}

void Pilot::add_sun_days(double days) {
    if (!sun_) return;
    sun_->add_days(days);
    place_sun();
}

/// The sun stays where it is in the world, also where its angles are those at a moving camera.
void Pilot::place_sun() {
    Geodetic const anchor = sun_anchor(view_);
    view_.sun = sun_place(sun_->to_sun(), anchor.latitude, anchor.longitude);
}

void Pilot::set_vertical_fov(double fov) {
    if (camera_) camera_->set_vertical_fov(std::clamp(fov, NARROWEST, WIDEST));
}

double Pilot::planet_radius() const { return stage_.planet().radius; }

double Pilot::ground_altitude() const {
    return stage_.ground_altitude(world_from_geodetic(view_.camera.place, planet_radius()));
}

double Pilot::lowest() const { return stage_.ground_altitude(camera_->camera().position) + EYES; }

double Pilot::speed() const { return camera_ ? camera_->speed(ground_altitude() + EYES) : 0; }

} // namespace alpenglow
