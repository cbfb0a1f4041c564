#include "scene/view.h"

#include "core/error.h"
#include "scene/file_keys.h"
#include "scene/view_reader.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;

/// Degrees to 12 places (0.1 micrometres on the ground), so that 46 does not become 46.00000000000001.
double degrees_for_file(double radians) { return std::round(glm::degrees(radians) * 1e12) / 1e12; }

Json camera_json(CameraPlace const& camera) {
    return {{"latitude", degrees_for_file(camera.place.latitude)},
            {"longitude", degrees_for_file(camera.place.longitude)},
            {"altitude", camera.place.altitude},
            {"heading", degrees_for_file(camera.heading)},
            {"pitch", degrees_for_file(camera.pitch)},
            {"roll", degrees_for_file(camera.roll)},
            {"fov", degrees_for_file(camera.vertical_fov)}};
}

Json sun_json(SunPlace const& sun) {
    if (sun.utc) return {{"utc", *sun.utc}};
    return {{"elevation", degrees_for_file(sun.elevation)}, {"azimuth", degrees_for_file(sun.azimuth)}};
}

Json scene_json(View const& view) {
    if (!view.placement) return view.scene;
    Placement const& placement = *view.placement;
    return {{"file", view.scene},
            {"latitude", degrees_for_file(placement.anchor.latitude)},
            {"longitude", degrees_for_file(placement.anchor.longitude)},
            {"altitude", placement.anchor.altitude},
            {"yaw", degrees_for_file(placement.yaw)},
            {"scale", placement.scale},
            {"curve", placement.curve}};
}

void add_changed_settings(Json& file, Settings const& settings) {
    for (SettingInfo const& info : setting_table()) {
        SettingValue const value = get_setting(settings, info);
        if (value == get_setting(Settings{}, info)) continue;
        std::visit([&](auto const& plain) { file[std::string(info.name)] = plain; }, value);
    }
}

} // namespace

Camera camera_at(CameraPlace const& place, double planet_radius) {
    Geodetic const& at = place.place;
    return {.position = world_from_geodetic(at, planet_radius),
            .world_from_camera =
                world_from_camera_angles(at.latitude, at.longitude, place.heading, place.pitch, place.roll),
            .vertical_fov = place.vertical_fov};
}

Placement scene_placement(View const& view) { return view.placement.value_or(Placement{.anchor = default_anchor}); }

Geodetic sun_anchor(View const& view) {
    if (!view.scene.empty()) return scene_placement(view).anchor;
    return {.latitude = view.camera.place.latitude, .longitude = view.camera.place.longitude};
}

View load_view(std::filesystem::path const& file) {
    json::File const text(file);
    std::vector<std::string_view> known = base_view_keys();
    known.push_back("camera");
    json::Object const object = text.root().object(known);
    View view = read_base_view(object, file);
    view.camera = read_camera(object.at("camera"));
    return view;
}

std::string view_text(View const& view) {
    Json file{{"planet", view.planet}, {"scene", scene_json(view)}, {"camera", camera_json(view.camera)},
              {"sun", sun_json(view.sun)}};
    add_changed_settings(file, view.settings);
    return file.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

World make_world(View const& view, Planet const& planet) {
    // Written so that NaN is refused too.
    if (!(view.camera.place.altitude > 0)) {
        throw Error(ErrorKind::bad_input,
                    fmt::format("the camera is inside the planet, at altitude {} m", view.camera.place.altitude),
                    "view " + view.name, "give an altitude above 0, the planet's reference radius");
    }
    Geodetic const anchor = sun_anchor(view);
    return {.planet = planet,
            .camera = camera_at(view.camera, planet.radius),
            .to_sun = sun_direction(view.sun, anchor.latitude, anchor.longitude)};
}

} // namespace alpenglow
