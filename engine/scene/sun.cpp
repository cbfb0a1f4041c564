#include "core/error.h"
#include "scene/view.h"

#include <array>
#include <charconv>
#include <cmath>
#include <erfa.h>
#include <optional>
#include <string_view>

namespace alpenglow {

namespace {

struct DateTime {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0;
    double second = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// YYYY-MM-DDThh:mm:ssZ, seconds or their fraction left out at will. Ranges are ERFA's business.
std::optional<DateTime> parse_utc(std::string_view text) {
    constexpr std::string_view SHAPE = "dddd-dd-ddTdd:dd";
    if (text.size() <= SHAPE.size() || text.size() > 40 || text.back() != 'Z') return std::nullopt;
    for (std::size_t i = 0; i < SHAPE.size(); ++i) {
        if (SHAPE[i] == 'd' ? !is_digit(text[i]) : text[i] != SHAPE[i]) return std::nullopt;
    }
    auto const whole = [&](std::size_t first, std::size_t count) {
        int value = 0;
        std::from_chars(text.data() + first, text.data() + first + count, value);
        return value;
    };
    DateTime time{whole(0, 4), whole(5, 2), whole(8, 2), whole(11, 2), whole(14, 2)};
    std::string_view const seconds = text.substr(SHAPE.size(), text.size() - SHAPE.size() - 1);
    if (seconds.empty()) return time;
    if (seconds.size() < 3 || seconds[0] != ':' || !is_digit(seconds[1])) return std::nullopt;
    auto const [end, error] =
        std::from_chars(seconds.data() + 1, seconds.data() + seconds.size(), time.second, std::chars_format::fixed);
    if (error != std::errc{} || end != seconds.data() + seconds.size()) return std::nullopt;
    return time;
}

[[noreturn]] void refuse(std::string const& utc, std::string const& what) {
    throw Error(ErrorKind::bad_input, "\"" + utc + "\" " + what, "sun's utc",
                "give a time from 1900 to 2100 like 2026-06-21T04:30:00Z");
}

/// A moment as two-part Julian dates, which ERFA adds up without loss.
struct Moment {
    double utc_1 = 0, utc_2 = 0;
    double tt_1 = 0, tt_2 = 0;
};

Moment moment_from_utc(std::string const& utc) {
    std::optional<DateTime> const time = parse_utc(utc);
    if (!time) refuse(utc, "is not a time in UTC");
    // Earth's ephemeris in ERFA is made for these years.
    if (time->year < 1900 || time->year > 2100) refuse(utc, "is too far from now for the sun's place");
    Moment moment;
    int const status = eraDtf2d("UTC", time->year, time->month, time->day, time->hour, time->minute, time->second,
                                &moment.utc_1, &moment.utc_2);
    // 1 only warns that the year's leap seconds are not known.
    if (status != 0 && status != 1) refuse(utc, "is no moment of the calendar");
    double tai_1 = 0, tai_2 = 0;
    eraUtctai(moment.utc_1, moment.utc_2, &tai_1, &tai_2);
    eraTaitt(tai_1, tai_2, &moment.tt_1, &moment.tt_2);
    return moment;
}

/// Apparent direction from the centre of the Earth in the frame of its celestial intermediate pole and origin:
/// aberration, precession and nutation. TT stands for TDB (2 ms); the sun's own motion in 8 minutes of light time is
/// 0.01".
glm::dvec3 apparent_sun(Moment const& moment) {
    eraASTROM astrometry;
    double origins = 0;
    eraApci13(moment.tt_1, moment.tt_2, &astrometry, &origins);
    double from_sun[2][3], from_barycentre[2][3];
    eraEpv00(moment.tt_1, moment.tt_2, from_sun, from_barycentre);
    double to_sun[3], apparent[3], intermediate[3], distance = 0;
    eraPn(from_sun[0], &distance, to_sun);
    for (double& component : to_sun) component = -component;
    eraAb(to_sun, astrometry.v, distance, astrometry.bm1, apparent);
    eraRxp(astrometry.bpn, apparent, intermediate);
    return {intermediate[0], intermediate[1], intermediate[2]};
}

} // namespace

glm::dvec3 sun_direction_from_utc(std::string const& utc) {
    Moment const moment = moment_from_utc(utc);
    glm::dvec3 const sun = apparent_sun(moment);
    double const angle = eraEra00(moment.utc_1, moment.utc_2); // UT1 = UTC: within 0.9 s, 0.004 degrees
    double const c = std::cos(angle), s = std::sin(angle);
    return glm::normalize(glm::dvec3(c * sun.x + s * sun.y, c * sun.y - s * sun.x, sun.z));
}

glm::dvec3 sun_direction(SunPlace const& sun, double latitude, double longitude) {
    if (sun.utc) return sun_direction_from_utc(*sun.utc);
    return world_from_elevation_azimuth(sun.elevation, sun.azimuth, latitude, longitude);
}

SunPlace sun_place(glm::dvec3 const& to_sun, double latitude, double longitude) {
    glm::dvec3 const local = glm::transpose(world_from_east_north_up(latitude, longitude)) * to_sun;
    return {.elevation = std::atan2(local.z, std::hypot(local.x, local.y)),
            .azimuth = std::atan2(local.x, local.y),
            .utc = std::nullopt};
}

} // namespace alpenglow
