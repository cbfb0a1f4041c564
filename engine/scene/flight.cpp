#include "scene/flight_path.h"

#include "scene/file_keys.h"
#include "scene/view_reader.h"

#include <fmt/format.h>

namespace alpenglow {

namespace {

using json::Object;
using json::Value;

/// What a key leaves out is as in the key before it.
Flight::Key read_key(Value const& value, Flight::Key const& before) {
    Object const object = value.object({"time", "camera", "sun", "exposure"});
    Flight::Key key = before;
    key.time = object.number(json::TIME);
    Value const camera = object.at("camera");
    key.camera = read_camera(camera);
    if (!camera.json().contains("fov")) key.camera.vertical_fov = before.camera.vertical_fov;
    if (object.has("sun")) key.sun = read_sun_place(object.at("sun"));
    if (object.has("exposure")) key.exposure = object.number(json::setting_key(*find_setting("exposure")));
    return key;
}

void check_order(Value const& value, std::vector<Flight::Key> const& keys) {
    double const time = keys.back().time;
    if (keys.size() == 1 && time != 0) value.refuse("the first key's time is not 0", "start at 0");
    if (keys.size() > 1 && time <= keys[keys.size() - 2].time) {
        value.refuse("its time is not after the key before it", "put the keys in order of time");
    }
}

std::vector<Flight::Key> read_keys(Value const& list, Flight const& flight) {
    Flight::Key before{.time = 0, .camera = {}, .sun = flight.base.sun, .exposure = flight.base.settings.exposure};
    std::vector<Flight::Key> keys;
    for (Value const& value : list.list()) {
        keys.push_back(read_key(value, keys.empty() ? before : keys.back()));
        check_order(value, keys);
        if (keys.back().camera.place.altitude < flight.ground) {
            value.refuse("the camera is below the flight's ground", "lower the flight's \"ground\", or fly higher");
        }
    }
    if (keys.size() < 2) list.refuse(fmt::format("{} keys make no flight", keys.size()), "give at least two");
    return keys;
}

} // namespace

Flight load_flight(std::filesystem::path const& file) {
    json::File const text(file);
    std::vector<std::string_view> known = base_view_keys();
    known.insert(known.end(), {"ground", "keys"});
    Object const object = text.root().object(known);
    Flight flight;
    flight.base = read_base_view(object, file);
    flight.name = flight.base.name;
    flight.ground = object.number(json::GROUND);
    flight.keys = read_keys(object.at("keys"), flight);
    flight.base.camera = flight.keys.front().camera;
    return flight;
}

View Flight::at(double time) const { return FlightPath(*this).at(time); }

} // namespace alpenglow
