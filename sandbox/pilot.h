#pragma once

#include "sandbox/stage.h"
#include "scene/fly_camera.h"
#include "scene/sun_clock.h"

#include <optional>

namespace alpenglow {

/// Whose hand the view is in: the flight's, until the user takes over just where it is.
class Pilot {
public:
    Pilot(Stage& stage, Flight flight);

    View const& view() const { return view_; }
    Settings& settings() { return view_.settings; } ///< the user's once the flight is over
    Planet const& planet() const { return stage_.planet(); } ///< as its file has it
    bool user_flies() const { return camera_.has_value(); }
    /// Does nothing the second time.
    void take_over();
    /// `dt` in [s]. The flight goes on, and stands still at its end; or the user's camera moves, never into the ground.
    void advance(double dt, FlyInput const& input);

    void add_sun_hours(double hours);
    void add_sun_days(double days);
    /// Nothing while the flight decides.
    std::optional<SunClock> const& sun() const { return sun_; }
    void set_vertical_fov(double fov); ///< [rad]

    double ground_altitude() const;    ///< [m] of what is under the camera
    double speed() const;              ///< [m/s] of the user's camera, without Shift

private:
    void fly(double dt, FlyInput const& input);
    double planet_radius() const;
    double lowest() const;
    void place_sun();

    Stage& stage_;
    Flight flight_;
    double time_ = 0; ///< [s] of the flight
    View view_;
    std::optional<FlyCamera> camera_;
    std::optional<SunClock> sun_;
};

} // namespace alpenglow
