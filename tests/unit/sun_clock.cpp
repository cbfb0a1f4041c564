#include "scene/sun_clock.h"

#include "scene/view.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

constexpr double DEGREE = M_PI / 180;

glm::dvec3 sun(double elevation, double azimuth, double latitude, double longitude) {
    return world_from_elevation_azimuth(elevation * DEGREE, azimuth * DEGREE, latitude * DEGREE, longitude * DEGREE);
}

double highest_at(double day, double latitude) {
    SunClock clock(sun(30, 180, latitude, 7.5), 7.5 * DEGREE);
    clock.add_days(day - clock.day());
    clock.add_hours(12 - clock.hour());
    return sun_place(clock.to_sun(), latitude * DEGREE, 7.5 * DEGREE).elevation / DEGREE;
}

} // namespace

TEST(SunClock, starts_with_the_sun_where_it_is) {
    for (glm::dvec3 const& to_sun : {sun(62, 175, 46, 7.5), sun(7, 85, 46, 7.5), sun(-20, 300, 46, 7.5), sun(80, 180, 70, 7.5), sun(90, 0, 90, 0)}) {
        EXPECT_LT(glm::length(SunClock(to_sun, 7.5 * DEGREE).to_sun() - to_sun), 1e-8);
    }
}

TEST(SunClock, the_sun_is_in_the_south_at_noon_and_in_the_east_before) {
    SunClock clock(sun(45, 180, 46, 170), 170 * DEGREE);
    EXPECT_NEAR(clock.hour(), 12, 1e-9);
    clock.add_hours(-6);
    EXPECT_LT(sun_place(clock.to_sun(), 46 * DEGREE, 170 * DEGREE).azimuth, M_PI / 2 + 0.1);
    clock.add_hours(30); // a day is 24 hours
    EXPECT_NEAR(clock.hour(), 12, 1e-9);
    EXPECT_NEAR(sun_place(clock.to_sun(), 46 * DEGREE, 170 * DEGREE).elevation, 45 * DEGREE, 1e-9);
}

TEST(SunClock, seasons_are_those_of_the_almanac) {
    // Noon heights at 46 N: 90 - 46 + declination. In four days (September's equinox on a circular orbit) the
    // declination moves 1.6 degrees at most.
    EXPECT_NEAR(highest_at(79.5, 46), 44, 0.4);
    EXPECT_NEAR(highest_at(171.5, 46), 44 + 23.44, 0.1);
    EXPECT_NEAR(highest_at(265.5, 46), 44, 1.6);
    EXPECT_NEAR(highest_at(354.5, 46), 44 - 23.44, 0.1);
}

TEST(SunClock, agrees_with_the_ephemeris) {
    // 4 May 2026, 10:00 UTC; a circular orbit is two days off in May.
    glm::dvec3 const to_sun = sun_direction_from_utc("2026-05-04T10:00:00Z");
    SunClock const clock(to_sun, 0);
    EXPECT_NEAR(clock.day(), 123.4, 2.5);
    EXPECT_NEAR(clock.hour(), 10, 0.1); // the equation of time is 3 minutes
}

TEST(SunClock, the_year_comes_round) {
    glm::dvec3 const start = sun(20, 100, 46, 7.5);
    SunClock clock(start, 7.5 * DEGREE);
    double largest = 0;
    for (int i = 0; i < 100; ++i) {
        double const before = clock.declination();
        clock.add_days(SunClock::DAYS_IN_YEAR / 100);
        largest = std::max(largest, std::abs(clock.declination() - before));
    }
    EXPECT_LT(glm::length(clock.to_sun() - start), 1e-9);
    EXPECT_LT(largest, 0.03); // [rad]: obliquity times 2 pi / 100, so that nothing jumps
}
