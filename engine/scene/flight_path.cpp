#include "scene/flight_path.h"

#include "scene/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

/// Height above the flight's ground at which climbing turns from even to logarithmic [m].
constexpr double SOFT_HEIGHT = 1;

/// From one point to another, in the space tangent at the first.
double step(double a, double b) { return b - a; }
glm::dvec3 step(glm::dvec3 const& a, glm::dvec3 const& b) { return interpolation::great_circle_step(a, b); }
glm::dvec3 step(glm::dquat const& a, glm::dquat const& b) { return interpolation::turn_between(a, b); }

/// The frame's pole: at a right angle to the path as a whole.
glm::dvec3 pole_of(std::vector<glm::dvec3> const& ups) {
    glm::dvec3 normal(0);
    for (std::size_t i = 0; i + 1 < ups.size(); ++i) {
        glm::dvec3 const turn = glm::cross(ups[i], ups[i + 1]);
        normal += glm::dot(turn, normal) < 0 ? -turn : turn; // a way back does not undo the way there
    }
    glm::dvec3 const up = ups.front();
    normal -= glm::dot(normal, up) * up;
    // Shorter than this, the path is a point as far as frames are concerned: any pole will do.
    constexpr double SHORT = 1e-9;
    if (glm::length(normal) > SHORT) return glm::normalize(normal);
    return glm::normalize(glm::cross(up, std::abs(up.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
}

} // namespace

FlightPath::FlightPath(Flight const& flight) : flight_(flight) {
    View first = flight.base;
    first.camera = flight.keys.front().camera;
    Geodetic const anchor = sun_anchor(first);
    for (Flight::Key const& key : flight.keys) {
        Geodetic const& place = key.camera.place;
        ups_.push_back(world_from_geodetic({place.latitude, place.longitude, 0}, 1));
        log_heights_.push_back(std::log(place.altitude - flight.ground + SOFT_HEIGHT));
        fovs_.push_back(key.camera.vertical_fov);
        exposures_.push_back(key.exposure);
        suns_.push_back(sun_direction(key.sun, anchor.latitude, anchor.longitude));
    }
    pole_ = pole_of(ups_);
    for (std::size_t i = 0; i < ups_.size(); ++i) {
        glm::dmat3 const world_from_camera = camera_at(flight.keys[i].camera, 1).world_from_camera;
        rotations_.push_back(glm::quat_cast(glm::transpose(world_from_local(ups_[i])) * world_from_camera));
    }
    for (std::size_t i = 0; i + 1 < ups_.size(); ++i) {
        double const pace = 1 / (flight.keys[i + 1].time - flight.keys[i].time);
        time_paces_.push_back({pace, pace});
    }
    for (std::size_t i = 0; i + 1 < ups_.size(); ++i) ground_paces_.push_back(ground_pace(i));
}

glm::dmat3 FlightPath::world_from_local(glm::dvec3 const& up) const {
    glm::dvec3 const east = glm::normalize(glm::cross(pole_, up));
    return {east, glm::cross(up, east), up};
}

/// Velocity at a key [per s]: between those that the two segments would have there by themselves.
template <typename Point>
auto FlightPath::key_rate(std::vector<Point> const& points, std::vector<Pace> const& paces, std::size_t key) const {
    auto const before = [&] { return -step(points[key], points[key - 1]) * paces[key - 1].end; };
    auto const after = [&] { return step(points[key], points[key + 1]) * paces[key].start; };
    if (key == 0) return after();
    if (key + 1 == points.size()) return before();
    return interpolation::monotone_rate(before(), after());
}

template <typename Point>
Point FlightPath::on_curve(std::vector<Point> const& points, std::vector<Pace> const& paces, std::size_t segment,
                           double u) const {
    auto const slope_a = key_rate(points, paces, segment) / paces[segment].start;
    auto const slope_b = key_rate(points, paces, segment + 1) / paces[segment].end;
    return interpolation::hermite(points[segment], slope_a, slope_b, points[segment + 1], u);
}

double FlightPath::log_height(std::size_t segment, double u) const {
    return on_curve(log_heights_, time_paces_, segment, u);
}

/// The integral of the height over the segment's u from 0 to `end`.
double FlightPath::height_integral(std::size_t segment, double end) const {
    // Gauss-Legendre with four points in each of 16 panels: 1e-9 of a climb from 2 m to 20 000 km.
    constexpr std::array NODES{0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
    constexpr std::array WEIGHTS{0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};
    constexpr int PANELS = 16;
    double sum = 0;
    for (int panel = 0; panel < PANELS; ++panel) {
        for (std::size_t i = 0; i < NODES.size(); ++i) {
            sum += WEIGHTS[i] * std::exp(log_height(segment, end * (panel + NODES[i]) / PANELS));
        }
    }
    return sum * end / PANELS;
}

/// Along the ground a segment is flown in proportion to the height: near the ground slowly, and a climb is a straight
/// line.
FlightPath::Pace FlightPath::ground_pace(std::size_t segment) const {
    double const whole = height_integral(segment, 1) / time_paces_[segment].start; // [m s]
    return {std::exp(log_heights_[segment]) / whole, std::exp(log_heights_[segment + 1]) / whole};
}

View FlightPath::at(double time) const {
    std::vector<Flight::Key> const& keys = flight_.keys;
    double const clamped = std::clamp(time, keys.front().time, keys.back().time);
    auto const next = std::upper_bound(keys.begin() + 1, keys.end() - 1, clamped,
                                       [](double t, Flight::Key const& key) { return t < key.time; });
    auto const segment = static_cast<std::size_t>(next - keys.begin() - 1);
    double const u = (clamped - keys[segment].time) * time_paces_[segment].start;
    double const way = height_integral(segment, u) / height_integral(segment, 1);

    glm::dvec3 const up = on_curve(ups_, ground_paces_, segment, way);
    Geodetic place = geodetic_from_world(up, 1);
    place.altitude = std::exp(log_height(segment, u)) - SOFT_HEIGHT + flight_.ground;
    glm::dmat3 const local_from_camera = glm::mat3_cast(on_curve(rotations_, time_paces_, segment, u));
    CameraAngles const angles =
        camera_angles(world_from_local(up) * local_from_camera, place.latitude, place.longitude);

    View view = flight_.base;
    view.name = flight_.name;
    view.camera = {place, angles.heading, angles.pitch, angles.roll, on_curve(fovs_, time_paces_, segment, u)};
    view.settings.exposure = on_curve(exposures_, time_paces_, segment, u);
    Geodetic const anchor = sun_anchor(view);
    view.sun = sun_place(on_curve(suns_, time_paces_, segment, u), anchor.latitude, anchor.longitude);
    return view;
}

} // namespace alpenglow
