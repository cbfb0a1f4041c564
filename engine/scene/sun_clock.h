#pragma once

#include <glm/glm.hpp>

namespace alpenglow {

/// The sun's way over the sky of a place, by the hour and by the day: it turns once a day about the planet's axis, and
/// its declination swings once a year. A circular orbit, so that the seasons are the Earth's within four days.
class SunClock {
public:
    static constexpr double DAYS_IN_YEAR = 365.2422;

    /// Starts with the sun just where it is, `to_sun` a unit vector in the world: in the half of the year in which days
    /// grow longer in the north. A sun that stands higher than the Earth's ever does leans the planet's axis to suit.
    SunClock(glm::dvec3 const& to_sun, double longitude);

    void add_hours(double hours);
    void add_days(double days);
    double hour() const { return hour_; } ///< true solar time at the longitude, 0 to 24; the sun is highest at 12
    double day() const { return day_; }   ///< since the year's start, 0 to DAYS_IN_YEAR
    double declination() const;           ///< [rad]
    glm::dvec3 to_sun() const;            ///< unit, world

private:
    double longitude_; ///< [rad]
    double obliquity_; ///< [rad]
    double hour_, day_;
};

} // namespace alpenglow
