#include "scene/view_reader.h"

#include "core/error.h"
#include "scene/file_keys.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using json::Object;
using json::Value;
namespace fs = std::filesystem;

constexpr std::string_view PLACEMENT_KEYS[] = {"latitude", "longitude", "altitude", "yaw", "scale", "curve"};

/// A path in a file starts from the file's own folder.
std::string resolve(std::string const& path, fs::path const& file) {
    return fs::absolute(file.parent_path() / path).lexically_normal().string();
}

std::string read_planet_name(Value const& value, fs::path const& file) {
    std::string const name = value.text();
    if (name.empty()) value.refuse("the planet has no name", "give a name from assets/planets, or a path");
    bool const is_path = name.find('/') != std::string::npos || name.ends_with(".json");
    return is_path ? resolve(name, file) : name;
}

std::string read_scene_file(Value const& value, fs::path const& file) {
    std::string const name = value.text();
    return name.empty() || name == "default" ? name : resolve(name, file);
}

Placement read_placement(Object const& object) {
    Placement placement;
    placement.anchor = {.latitude = glm::radians(object.number(json::LATITUDE)),
                        .longitude = glm::radians(object.number(json::LONGITUDE)),
                        .altitude = object.number(json::ANCHOR_ALTITUDE)};
    placement.yaw = glm::radians(object.number(json::YAW));
    placement.scale = object.number(json::SCALE);
    if (object.has("curve")) placement.curve = object.at("curve").boolean();
    return placement;
}

int read_index(Value const& value) {
    double const index = value.number(json::SCENE_INDEX);
    if (index != std::floor(index)) value.refuse(value.quoted() + " is not a whole number", "count the scenes from 0");
    return static_cast<int>(index);
}

void read_scene(Value const& value, fs::path const& file, View& view) {
    if (value.is_text()) {
        view.scene = read_scene_file(value, file);
        return;
    }
    Object const object = value.object({"file", "index", "latitude", "longitude", "altitude", "yaw", "scale", "curve"});
    view.scene = read_scene_file(object.at("file"), file);
    if (object.has("index")) view.scene_index = read_index(object.at("index"));
    for (std::string_view const key : PLACEMENT_KEYS) {
        if (object.has(key)) {
            view.placement = read_placement(object);
            return;
        }
    }
}

int read_whole(Value const& value, SettingInfo const& info) {
    nlohmann::json const& number = value.json();
    double const real = number.is_number() ? number.get<double>() : NAN;
    if (!(std::abs(real) <= 1e9) || real != std::floor(real))
        value.refuse(value.quoted() + " is not a whole number", "give " + range_text(info));
    return static_cast<int>(real);
}

/// Of the setting's own type.
SettingValue read_setting_value(Value const& value, SettingInfo const& info) {
    switch (info.member.index()) {
    case 0:
        return value.boolean();
    case 1:
        return read_whole(value, info);
    case 2:
        return value.number(json::setting_key(info));
    default:
        return value.text();
    }
}

void read_settings(Object const& object, Settings& settings) {
    for (SettingInfo const& info : setting_table()) {
        if (!object.has(info.name)) continue;
        Value const value = object.at(info.name);
        SettingValue const read = read_setting_value(value, info);
        if (!in_range(info, read)) value.refuse(value.quoted() + " is out of range", "give " + range_text(info));
        set_setting(settings, info, read);
    }
}

void check_moment(Value const& value, std::string const& utc) {
    try {
        sun_direction_from_utc(utc);
    } catch (Error const& error) {
        value.refuse(error.what(), "");
    }
}

} // namespace

CameraPlace read_camera(Value const& value) {
    std::vector<std::string_view> known;
    for (json::NumberKey const& key : json::CAMERA_KEYS) known.push_back(key.name);
    Object const object = value.object(known);
    return {.place = {.latitude = glm::radians(object.number(json::LATITUDE)),
                      .longitude = glm::radians(object.number(json::LONGITUDE)),
                      .altitude = object.number(json::CAMERA_ALTITUDE)},
            .heading = glm::radians(object.number(json::HEADING)),
            .pitch = glm::radians(object.number(json::PITCH)),
            .roll = glm::radians(object.number(json::ROLL)),
            .vertical_fov = glm::radians(object.number(json::FOV))};
}

SunPlace read_sun_place(Value const& value) {
    Object const object = value.object({"elevation", "azimuth", "utc"});
    SunPlace sun;
    if (object.has("utc")) {
        if (object.has("elevation") || object.has("azimuth")) {
            value.refuse("has both utc and angles", "give utc, or elevation and azimuth");
        }
        sun.utc = object.at("utc").text();
        check_moment(object.at("utc"), *sun.utc);
        return sun;
    }
    sun.elevation = glm::radians(object.number(json::ELEVATION));
    sun.azimuth = glm::radians(object.number(json::AZIMUTH));
    return sun;
}

std::vector<std::string_view> base_view_keys() {
    std::vector<std::string_view> known{"$schema", "description", "planet", "scene", "sun"};
    for (SettingInfo const& info : setting_table()) known.push_back(info.name);
    return known;
}

View read_base_view(Object const& object, fs::path const& file) {
    View view;
    view.name = file.stem().string();
    if (object.has("planet")) view.planet = read_planet_name(object.at("planet"), file);
    if (object.has("scene")) read_scene(object.at("scene"), file, view);
    if (object.has("sun")) view.sun = read_sun_place(object.at("sun"));
    read_settings(object, view.settings);
    return view;
}

} // namespace alpenglow
