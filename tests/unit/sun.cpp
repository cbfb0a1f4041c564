#include "scene/geodesy.h"
#include "scene/view.h"
#include "support/files.h"

#include <cmath>
#include <numbers>

using namespace alpenglow;

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }
double declination(std::string const& utc) { return degrees(std::asin(sun_direction_from_utc(utc).z)); }
/// East longitude that has the sun in its meridian.
double subsolar_longitude(std::string const& utc) {
    glm::dvec3 const sun = sun_direction_from_utc(utc);
    return degrees(std::atan2(sun.y, sun.x));
}

/// The Astronomical Almanac's low-precision formulas (page C5): 0.01 degrees from 1950 to 2050. `days` from J2000.
struct LowPrecisionSun {
    double declination, subsolar_longitude; // [degrees]
    explicit LowPrecisionSun(double days) {
        auto const radians = [](double d) { return d * std::numbers::pi / 180; };
        double const mean_longitude = 280.460 + 0.9856474 * days;
        double const anomaly = radians(357.528 + 0.9856003 * days);
        double const longitude = radians(mean_longitude + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2 * anomaly));
        double const obliquity = radians(23.439 - 4e-7 * days);
        declination = degrees(std::asin(std::sin(obliquity) * std::sin(longitude)));
        double const ascension = degrees(std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)));
        double const greenwich = 280.46062 + 360.98564737 * days; // mean sidereal time
        subsolar_longitude = std::remainder(ascension - greenwich, 360.0);
    }
};

} // namespace

TEST(SunFromUtc, solstices_and_equinoxes_of_2026) {
    // Published instants, to the minute; the declination moves by 0.0165 degrees an hour at an equinox.
    EXPECT_NEAR(declination("2026-03-20T14:46Z"), 0, 0.003);
    EXPECT_NEAR(declination("2026-09-23T00:05Z"), 0, 0.003);
    EXPECT_NEAR(declination("2026-06-21T08:25:00Z"), 23.4368, 0.003); // the true obliquity of that year is 23.4365 +- 0.0026
    EXPECT_NEAR(declination("2026-12-21T20:50:00Z"), -23.4368, 0.003);
}

TEST(SunFromUtc, agrees_with_the_published_example_of_the_solar_position_algorithm) {
    // I. Reda and A. Andreas, Solar Position Algorithm for Solar Radiation Applications (2008), table A5.1: zenith 50.11162
    // degrees with a refraction of 0.01633, azimuth 194.34024; seen from the surface (parallax 0.0017).
    glm::dvec3 const sun = sun_direction_from_utc("2003-10-17T19:30:30Z");
    SunPlace const place = sun_place(sun, 39.742476 / 180 * std::numbers::pi, -105.1786 / 180 * std::numbers::pi);
    EXPECT_NEAR(degrees(place.elevation), 90 - 50.11162 - 0.01633, 0.006);
    EXPECT_NEAR(degrees(place.azimuth) + 360, 194.34024, 0.006);
}

TEST(SunFromUtc, agrees_with_the_almanacs_short_formulas_through_the_years) {
    struct Case { char const* utc; double days; }; // days from 2000-01-01T12:00
    for (Case const c : {Case{"2000-01-01T12:00:00Z", 0}, {"2026-06-21T04:30:00Z", 9667.6875}, {"2024-02-29T00:00:00Z", 8824.5},
                         {"1969-07-20T20:17:40Z", -11121.65439815}, {"2049-11-03T18:00:00Z", 18204.25}}) {
        LowPrecisionSun const expected(c.days);
        // 0.01 of the formulas, 0.005 of nutation and UT1 in the hour angle
        EXPECT_NEAR(declination(c.utc), expected.declination, 0.012) << c.utc;
        EXPECT_NEAR(std::remainder(subsolar_longitude(c.utc) - expected.subsolar_longitude, 360.0), 0, 0.02) << c.utc;
    }
}

TEST(SunFromUtc, stands_highest_at_noon) {
    // Local noon in the Alps at midsummer: 90 - latitude + declination. The equation of time is -1.8 minutes.
    SunPlace const noon = sun_place(sun_direction_from_utc("2026-06-21T11:31:50Z"), default_anchor.latitude, default_anchor.longitude);
    EXPECT_NEAR(degrees(noon.elevation), 90 - 46 + 23.436, 0.05);
    EXPECT_NEAR(std::abs(degrees(noon.azimuth)), 180, 0.2);
}

TEST(SunPlace, is_the_inverse_of_the_direction) {
    SunPlace const sun{.elevation = 0.3, .azimuth = -2, .utc = {}};
    SunPlace const back = sun_place(sun_direction(sun, 1.1, -3), 1.1, -3);
    EXPECT_NEAR(back.elevation, 0.3, 1e-14);
    EXPECT_NEAR(back.azimuth, -2, 1e-14);
}

TEST(SunFromUtc, what_is_no_time_is_refused) {
    for (char const* utc : {"", "Z", "2026-06-21", "2026-06-21T04:30:00", "2026-06-21 04:30:00Z", "2026-13-21T04:30:00Z", "2026-02-30T04:30:00Z",
                            "2026-06-21T24:30:00Z", "2026-06-21T04:60:00Z", "2026-06-21T04:30:61Z", "2026-06-21T04:30:nanZ", "2026-06-21T04:30:-1Z",
                            "2026-06-21T04:30:0x1Z", "2026-06-21T04:30:Z", "1899-06-21T04:30:00Z", "2101-06-21T04:30:00Z", "-026-06-21T04:30Z",
                            "2026-06-21T04:30:60Z"}) {
        test::expect_error(ErrorKind::bad_input, {std::string("\"") + utc + "\"", "2026-06-21T04:30:00Z"}, [&] { sun_direction_from_utc(utc); });
    }
    EXPECT_NO_THROW(sun_direction_from_utc("2016-12-31T23:59:60.5Z")); // a leap second that was
}
