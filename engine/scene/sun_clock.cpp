#include "scene/sun_clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

constexpr double PI = std::numbers::pi;
constexpr double EARTH_OBLIQUITY = 0.40909; // [rad] 23.439 degrees, J2000 (IAU 2006)
constexpr double MARCH_EQUINOX = 79;        // [days] 21 March, 0 h

double wrapped(double value, double period) { return value - period * std::floor(value / period); }

} // namespace

SunClock::SunClock(glm::dvec3 const& to_sun, double longitude) : longitude_(longitude) {
    double const start = std::asin(std::clamp(to_sun.z, -1.0, 1.0));
    obliquity_ = std::max(EARTH_OBLIQUITY, std::abs(start));
    double const along_year = std::asin(std::clamp(std::sin(start) / std::sin(obliquity_), -1.0, 1.0));
    day_ = wrapped(MARCH_EQUINOX + along_year / (2 * PI) * DAYS_IN_YEAR, DAYS_IN_YEAR);
    double const sun_longitude = std::atan2(to_sun.y, to_sun.x);
    hour_ = wrapped(12 + (longitude - sun_longitude) / PI * 12, 24);
}

void SunClock::add_hours(double hours) { hour_ = wrapped(hour_ + hours, 24); }

void SunClock::add_days(double days) { day_ = wrapped(day_ + days, DAYS_IN_YEAR); }

double SunClock::declination() const {
    return std::asin(std::sin(obliquity_) * std::sin((day_ - MARCH_EQUINOX) / DAYS_IN_YEAR * 2 * PI));
}

glm::dvec3 SunClock::to_sun() const {
    double const sun_longitude = longitude_ - (hour_ - 12) / 12 * PI;
    double const c = std::cos(declination());
    return {c * std::cos(sun_longitude), c * std::sin(sun_longitude), std::sin(declination())};
}

} // namespace alpenglow
