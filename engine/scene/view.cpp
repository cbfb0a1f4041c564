#include "scene/view.h"

#include "core/error.h"
#include "scene/air_changes.h"
#include "scene/file_keys.h"
#include "scene/view_reader.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;
using json::Value;

/// Degrees to 12 places (0.1 micrometres on the ground), so that 46 does not become 46.00000000000001.
double degrees_for_file(double radians) { return std::round(glm::degrees(radians) * 1e12) / 1e12; }

Json camera_json(View const& view) {
    if (!view.scene_camera.empty()) return {{"gltf", view.scene_camera}};
    CameraPlace const& camera = view.camera;
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
    if (!view.placement && !view.scene_index) return view.scene;
    Json scene{{"file", view.scene}};
    if (view.scene_index) scene["index"] = *view.scene_index;
    if (!view.placement) return scene;
    Placement const& placement = *view.placement;
    scene["latitude"] = degrees_for_file(placement.anchor.latitude);
    scene["longitude"] = degrees_for_file(placement.anchor.longitude);
    scene["altitude"] = placement.anchor.altitude;
    scene["yaw"] = degrees_for_file(placement.yaw);
    scene["scale"] = placement.scale;
    scene["curve"] = placement.curve;
    return scene;
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

CameraPlace camera_place(SceneCamera const& camera, Placement const& placement, double planet_radius) {
    glm::dmat4 const world = world_from_scene(placement, planet_radius) * camera.scene_from_camera;
    CameraPlace place{.place = geodetic_from_world(glm::dvec3(world[3]), planet_radius),
                      .vertical_fov = camera.vertical_fov};
    // A node's scale and shear are no part of a camera: it keeps where it looks and which side is up.
    glm::dvec3 const back = glm::normalize(glm::dvec3(world[2]));
    glm::dvec3 const right = glm::normalize(glm::cross(glm::dvec3(world[1]), back));
    CameraAngles const angles =
        camera_angles({right, glm::cross(back, right), back}, place.place.latitude, place.place.longitude);
    place.heading = angles.heading, place.pitch = angles.pitch, place.roll = angles.roll;
    return place;
}

View with_scene_camera(View view, std::vector<SceneCamera> const& cameras, double planet_radius) {
    if (view.scene_camera.empty()) return view;
    std::string names;
    for (SceneCamera const& camera : cameras) {
        names += (names.empty() ? "" : ", ") + camera.name;
        if (camera.name != view.scene_camera) continue;
        view.camera = camera_place(camera, scene_placement(view), planet_radius);
        view.scene_camera.clear();
        return view;
    }
    throw Error(ErrorKind::bad_input, "the scene has no camera \"" + view.scene_camera + "\"", "view " + view.name,
                names.empty() ? "it has none; give latitude, longitude and altitude" : "it has " + names);
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
    Value const camera = object.at("camera");
    if (camera.json().is_object() && camera.json().contains("gltf"))
        view.scene_camera = camera.object({"gltf"}).at("gltf").text();
    else
        view.camera = read_camera(camera);
    return view;
}

std::string view_text(View const& view) {
    Json file{{"planet", view.planet},
              {"scene", scene_json(view)},
              {"camera", camera_json(view)},
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
    World world{.planet = planet,
                .camera = camera_at(view.camera, planet.radius),
                .to_sun = sun_direction(view.sun, anchor.latitude, anchor.longitude)};
    Settings const& settings = view.settings;
    world.planet.air = changed_air(std::move(world.planet.air), settings.air_without, settings.air_phases);
    return world;
}

} // namespace alpenglow
