#include "scene/geodesy.h"
#include "scene/view.h"
#include "support/files.h"

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

using namespace alpenglow;
using test::expect_error;
using Json = nlohmann::json;

namespace {

constexpr double PI = std::numbers::pi;
constexpr double RADIUS = 6'360'000;

Flight::Key key(double time, double latitude, double longitude, double altitude, double heading = 0, double pitch = 0) {
    return {.time = time,
            .camera = {.place = {latitude, longitude, altitude}, .heading = heading, .pitch = pitch, .vertical_fov = 1},
            .sun = {.elevation = 0.1, .azimuth = 1, .utc = {}},
            .exposure = 0};
}

Flight make_flight(std::vector<Flight::Key> keys) {
    Flight flight;
    flight.base.scene = "default";
    flight.keys = std::move(keys);
    return flight;
}

/// From 2 m to 20 000 km, round two corners and turning all the while.
Flight great_climb() {
    return make_flight({key(0, 0.80, 0.13, 2, 0.1, 0.1), key(8, 0.80, 0.1301, 2), key(20, 0.801, 0.131, 700, 1.5, 0), key(30, 0.79, 0.14, 12e3, 2.5, -0.2),
                        key(45, 0.7, 0.1, 4e5, 3.0, -0.4), key(60, 0.3, 0.5, 2e7, 3.3, -PI / 2)});
}

glm::dvec3 up_at(Flight const& flight, double t) {
    Geodetic const place = flight.at(t).camera.place;
    return world_from_geodetic({place.latitude, place.longitude, 0}, 1);
}

double log_altitude(Flight const& flight, double t) { return std::log(flight.at(t).camera.place.altitude + 1); }

glm::dmat3 rotation(Flight const& flight, double t) { return camera_at(flight.at(t).camera, RADIUS).world_from_camera; }

/// Angle of the rotation between two orientations [rad]; from the skew part, which keeps small angles.
double angle_between(glm::dmat3 const& a, glm::dmat3 const& b) {
    glm::dmat3 const turn = b * glm::transpose(a);
    glm::dvec3 const twice_sine{turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]};
    return std::atan2(glm::length(twice_sine), turn[0][0] + turn[1][1] + turn[2][2] - 1);
}

/// The largest jump of a quantity's rate (in units that may change with time) from one short step to the next, over its
/// largest rate, for two step lengths. Where the rate is continuous, a shorter step has a smaller jump, in proportion.
struct Jumps {
    double coarse, fine;
};
template <typename Value>
Jumps rate_jumps(double duration, std::function<Value(double)> const& value, std::function<double(double)> const& unit = [](double) { return 1.0; }) {
    auto const largest = [&](int steps) {
        double const dt = duration / steps;
        double jump = 0, fastest = 0;
        Value before{}, last = value(0);
        for (int i = 1; i <= steps; ++i) {
            Value const now = value(i * dt), rate = (now - last) / (dt * unit((i - 0.5) * dt));
            if constexpr (std::is_same_v<Value, double>) {
                if (i > 1) jump = std::max(jump, std::abs(rate - before));
                fastest = std::max(fastest, std::abs(rate));
            } else {
                if (i > 1) jump = std::max(jump, glm::length(rate - before));
                fastest = std::max(fastest, glm::length(rate));
            }
            before = rate, last = now;
        }
        return jump / fastest;
    };
    return {largest(1200), largest(12000)};
}

void expect_smooth(Jumps const& jumps, char const* what) {
    EXPECT_LT(jumps.fine, 0.02) << what;
    EXPECT_LT(jumps.fine, 0.2 * jumps.coarse + 1e-6) << what << ": the rate jumps";
}

} // namespace

TEST(Flight, passes_through_its_keys) {
    Flight const flight = great_climb();
    for (Flight::Key const& k : flight.keys) {
        View const view = flight.at(k.time);
        EXPECT_NEAR(view.camera.place.altitude, k.camera.place.altitude, 1e-9 * (1 + k.camera.place.altitude));
        EXPECT_NEAR(glm::length(camera_at(view.camera, RADIUS).position - camera_at(k.camera, RADIUS).position), 0, 1e-8 * (1 + k.camera.place.altitude));
        EXPECT_LT(angle_between(rotation(flight, k.time), camera_at(k.camera, RADIUS).world_from_camera), 1e-8);
        EXPECT_NEAR(view.sun.elevation, 0.1, 1e-12);
        EXPECT_NEAR(view.sun.azimuth, 1, 1e-12);
    }
    EXPECT_EQ(flight.at(-5).camera.place.altitude, flight.at(0).camera.place.altitude);
    EXPECT_EQ(flight.at(99).camera.place.altitude, flight.at(60).camera.place.altitude);
}

TEST(Flight, has_no_jump_in_any_rate_from_2_m_to_20_000_km) {
    Flight const flight = great_climb();
    expect_smooth(rate_jumps<double>(60, [&](double t) { return log_altitude(flight, t); }), "log altitude");
    // Steps over the ground measured in heights, as the eye sees them.
    auto const height = [&](double t) { return flight.at(t).camera.place.altitude + 1; };
    expect_smooth(rate_jumps<glm::dvec3>(60, [&](double t) { return RADIUS * up_at(flight, t); }, height), "ground point");
    for (int axis = 0; axis < 3; ++axis) {
        expect_smooth(rate_jumps<glm::dvec3>(60, [&](double t) { return rotation(flight, t)[axis]; }), "orientation");
    }
}

TEST(Flight, the_smoothness_test_sees_a_planted_corner) {
    auto const corner = [](double t) { return std::abs(t - 29.973); };
    Jumps const jumps = rate_jumps<double>(60, corner);
    EXPECT_GT(jumps.fine, 0.2 * jumps.coarse + 1e-6);
}

TEST(Flight, altitude_never_overshoots) {
    Flight const flight = great_climb();
    double last = 0;
    for (int i = 0; i <= 6000; ++i) {
        double const altitude = flight.at(i * 0.01).camera.place.altitude;
        EXPECT_GE(altitude, last * (1 - 1e-12)) << i;
        last = altitude;
    }
}

TEST(Flight, two_keys_make_an_even_climb_on_a_great_circle) {
    Flight const flight = make_flight({key(0, 0, 0, 1), key(10, 0, 0.5, 2e7 - 1)});
    for (double const t : {1.0, 3.0, 5.0, 8.0}) {
        EXPECT_NEAR(log_altitude(flight, t), std::log(2.0) + t / 10 * std::log(1e7), 1e-12);
        EXPECT_NEAR(flight.at(t).camera.place.latitude, 0, 1e-15);
        // A straight line: the way over the ground is in proportion to the climb.
        EXPECT_NEAR(flight.at(t).camera.place.longitude / 0.5, (flight.at(t).camera.place.altitude - 1) / (2e7 - 2), 1e-8);
    }
}

TEST(Flight, close_to_the_ground_it_moves_slowly) {
    Flight const flight = make_flight({key(0, 0.8, 0.13, 10), key(10, 0.8, 0.2, 1e6)});
    // A tenth of the time is 40 m of climb, and a straight line to the second key.
    double const angle = glm::length(up_at(flight, 1) - up_at(flight, 0)), whole = glm::length(up_at(flight, 10) - up_at(flight, 0));
    EXPECT_LT(angle / whole, 1e-4);
}

TEST(Flight, crosses_the_pole_and_the_date_line_without_a_turn) {
    Flight const pole = make_flight({key(0, 1.5, 0.3, 1e5), key(10, 1.5, 0.3 - PI, 1e5, PI)}); // straight on over the pole
    for (int i = 0; i < 100; ++i) {
        glm::dvec3 const forward_now = -rotation(pole, i * 0.1)[2], forward_next = -rotation(pole, i * 0.1 + 0.1)[2];
        EXPECT_LT(glm::length(forward_next - forward_now), 0.01) << i;
        EXPECT_NEAR(pole.at(i * 0.1).camera.pitch, 0, 1e-9);
    }
    EXPECT_GT(pole.at(5).camera.place.latitude, PI / 2 - 1e-9);
    Flight const line = make_flight({key(0, 0.1, PI - 0.01, 1e4), key(10, 0.1, -PI + 0.01, 1e4)});
    EXPECT_NEAR(glm::dot(up_at(line, 5), world_from_geodetic({0.1, PI, 0}, 1)), 1, 1e-8);
}

TEST(Flight, turns_the_short_way_and_never_flips) {
    Flight const flight = make_flight({key(0, 0.8, 0.1, 100, 3.0), key(10, 0.8, 0.1, 100, -3.0), key(20, 0.8, 0.1, 100, -2.5, -1), key(30, 0.8, 0.1, 100, 3.1, 0.5)});
    EXPECT_NEAR(std::abs(flight.at(5).camera.heading), PI, 0.05);
    for (int i = 0; i < 300; ++i) {
        EXPECT_LT(angle_between(rotation(flight, i * 0.1), rotation(flight, i * 0.1 + 0.1)), 0.05) << i;
        EXPECT_GT(glm::dot(rotation(flight, i * 0.1)[1], up_at(flight, 0)), 0) << "upside down at " << i;
    }
}

TEST(Flight, the_sun_goes_along_a_great_circle_and_exposure_never_overshoots) {
    Flight flight = make_flight({key(0, 0.8, 0.1, 100), key(10, 0.8, 0.1, 100), key(20, 0.8, 0.1, 100)});
    flight.keys[1].sun.elevation = flight.keys[2].sun.elevation = 1.1;
    flight.keys[1].exposure = 3, flight.keys[2].exposure = 3;
    EXPECT_NEAR(flight.at(3).sun.azimuth, 1, 1e-12);
    double last = 0;
    for (int i = 0; i <= 200; ++i) {
        View const view = flight.at(i * 0.1);
        EXPECT_GE(view.settings.exposure, last);
        EXPECT_LE(view.settings.exposure, 3 + 1e-12);
        EXPECT_LE(view.sun.elevation, 1.1 + 1e-12);
        last = view.settings.exposure;
    }
}

TEST(Flight, without_a_scene_the_sun_stays_where_it_is_in_the_world) {
    Flight flight = great_climb();
    flight.base.scene.clear();
    glm::dvec3 const start = make_world(flight.at(0), make_earth()).to_sun;
    for (double const t : {20.0, 40.0, 60.0}) EXPECT_LT(glm::length(make_world(flight.at(t), make_earth()).to_sun - start), 1e-12);
}

TEST(Flight, the_stored_ones_stay_above_their_ground_and_move_evenly) {
    for (auto const& entry : std::filesystem::directory_iterator(test::assets() / "flights")) {
        Flight const flight = load_flight(entry.path());
        double const step = flight.duration() / 240;
        for (double t = step; t <= flight.duration(); t += step) {
            // A fifth of a second's headway: never more than a third of the height, whatever the height.
            double const ratio = (flight.at(t).camera.place.altitude - flight.ground + 1) / (flight.at(t - step).camera.place.altitude - flight.ground + 1);
            EXPECT_LT(std::abs(std::log(ratio)), 0.33) << entry.path() << " at " << t;
        }
    }
}

namespace {

constexpr char GOOD[] = R"({"planet": "earth", "scene": "default", "ground": 100, "exposure": 2, "samples": 8, "sun": {"elevation": 5, "azimuth": 90},
    "keys": [{"time": 0, "camera": {"latitude": 46, "longitude": 7, "altitude": 200, "fov": 40}},
             {"time": 5, "camera": {"latitude": 46, "longitude": 8, "altitude": 900}, "exposure": 1, "sun": {"utc": "2026-06-21T04:30:00Z"}}]})";

Flight load_text(std::string const& text) {
    test::TemporaryFolder const folder;
    return load_flight(folder.write("bad.json", text));
}

} // namespace

TEST(FlightFiles, a_key_without_sun_exposure_or_fov_keeps_those_before) {
    Flight const flight = load_text(GOOD);
    EXPECT_EQ(flight.name, "bad");
    EXPECT_EQ(flight.ground, 100);
    EXPECT_EQ(flight.duration(), 5);
    EXPECT_EQ(flight.base.settings.samples, 8);
    ASSERT_EQ(flight.keys.size(), 2u);
    EXPECT_EQ(flight.keys[0].exposure, 2);
    EXPECT_EQ(flight.keys[1].exposure, 1);
    EXPECT_DOUBLE_EQ(flight.keys[0].sun.azimuth, PI / 2);
    EXPECT_TRUE(flight.keys[1].sun.utc);
    EXPECT_DOUBLE_EQ(flight.keys[1].camera.vertical_fov, flight.keys[0].camera.vertical_fov);
    EXPECT_EQ(flight.at(2).settings.samples, 8);
}

TEST(FlightFiles, bad_ones_are_refused_with_the_place_and_the_reason) {
    struct Case { std::string pointer; Json value; std::vector<std::string> parts; };
    Json const camera{{"latitude", 46}, {"longitude", 7}, {"altitude", 200}};
    std::vector<Case> const cases{
        {"/key", 1, {"bad.json: unknown key \"key\"", "did you mean keys?"}},
        {"/camera", camera, {"unknown key \"camera\""}},
        {"/keys", nullptr, {"has no \"keys\""}},
        {"/keys", Json::array(), {"at /keys", "0 keys make no flight"}},
        {"/keys/1", nullptr, {"at /keys", "1 keys make no flight"}},
        {"/keys", 3, {"at /keys", "3 is not a list"}},
        {"/keys/0", "start", {"at /keys/0", "\"start\" is not an object"}},
        {"/keys/0/time", 1, {"at /keys/0", "first key's time is not 0"}},
        {"/keys/1/time", 0, {"at /keys/1", "not after the key before"}},
        {"/keys/1/time", -1, {"at /keys/1/time", "out of range"}},
        {"/keys/1/time", "later", {"at /keys/1/time", "\"later\" is not a number"}},
        {"/keys/1/tiem", 3, {"at /keys/1", "unknown key \"tiem\"", "did you mean time?"}},
        {"/keys/1/camera/altitude", 50, {"at /keys/1", "below the flight's ground"}},
        {"/keys/1/camera/altitude", -1, {"at /keys/1/camera/altitude", "out of range"}},
        {"/keys/1/camera", nullptr, {"at /keys/1", "has no \"camera\""}},
        {"/keys/1/sun", Json{{"utc", "soon"}}, {"at /keys/1/sun/utc", "\"soon\" is not a time"}},
        {"/keys/1/exposure", 1000, {"at /keys/1/exposure", "out of range"}},
        {"/ground", -1, {"at /ground", "out of range"}},
        {"/samples", 0, {"at /samples", "4 to 1024"}},
    };
    for (Case const& c : cases) {
        Json file = Json::parse(GOOD);
        Json::json_pointer const at(c.pointer);
        if (!c.value.is_null()) file[at] = c.value;
        else if (c.pointer == "/keys/1") file["keys"].erase(1);
        else file[at.parent_pointer()].erase(at.back());
        expect_error(ErrorKind::bad_input, c.parts, [&] { load_text(file.dump()); });
    }
    expect_error(ErrorKind::bad_input, {"/nonexistent/f.json", "No such file"}, [] { load_flight("/nonexistent/f.json"); });
}
