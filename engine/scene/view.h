#pragma once

#include "core/settings.h"
#include "scene/camera.h"
#include "scene/planet.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow {

/// A camera as people say it; angles in radians here, in degrees in files.
struct CameraPlace {
    Geodetic place{};
    double heading = 0, pitch = 0, roll = 0;
    double vertical_fov = 1.0471975512;
};

Camera camera_at(CameraPlace const& place, double planet_radius);
/// A scene's own camera, where the scene stands.
CameraPlace camera_place(SceneCamera const& camera, Placement const& placement, double planet_radius);

/// The sun as given in a file: a direction in the local frame of the scene's anchor (of the camera's ground point where
/// there is no scene), or a moment in UTC.
struct SunPlace {
    double elevation = 0.5, azimuth = 3.14159265; ///< [rad]
    std::optional<std::string> utc{};             ///< ISO 8601; decides where given
};

/// Unit vector to the sun in the world frame. A UTC time goes through ERFA: apparent place, Earth's rotation; no
/// refraction.
glm::dvec3 sun_direction(SunPlace const& sun, double latitude, double longitude);
/// The same for a time like 2026-06-21T04:30:00Z, 1900 to 2100. Within 0.01 degrees of the almanac: UT1 is taken as UTC
/// (0.004), the place is seen from Earth's centre (0.0024), polar motion is left out. Throws Error(bad_input).
glm::dvec3 sun_direction_from_utc(std::string const& utc);
/// The inverse: elevation and azimuth at a place of a unit direction in the world.
SunPlace sun_place(glm::dvec3 const& to_sun, double latitude, double longitude);

/// Where a scene without a placement of its own stands. The procedural planet has sea here.
inline constexpr Geodetic default_anchor{.latitude = 0.80285145591739149 /* 46 N */,
                                         .longitude = 0.13089969389957473 /* 7.5 E */};

/// What a view file says (assets/view.schema.json).
struct View {
    std::string name{};                   ///< the file's stem
    std::string planet = "earth";         ///< name in assets/planets, or a path
    std::string scene{};                  ///< path, "default" for the generated terrain, empty for none
    std::optional<Placement> placement{}; ///< default: the scene's own
    std::optional<int> scene_index{};     ///< which of the file's scenes; the file's default unless given
    CameraPlace camera{};
    std::string scene_camera{};           ///< where not empty, the scene's camera of this name stands for `camera`
    SunPlace sun{};
    Settings settings{};
};

/// Throws Error(bad_input) that names the file and the key: unknown keys, wrong types, impossible values.
View load_view(std::filesystem::path const& file);
/// Text that load_view reads back as the same view, to the last digit that matters.
std::string view_text(View const& view);

/// The view's placement, or the default anchor's.
Placement scene_placement(View const& view);
/// `view` with its scene's camera looked up, where it names one. Throws Error(bad_input) where there is none of that
/// name.
View with_scene_camera(View view, std::vector<SceneCamera> const& cameras, double planet_radius);
/// Where the sun's elevation and azimuth are taken: the scene's anchor, or the camera's ground point where there is no
/// scene.
Geodetic sun_anchor(View const& view);

/// What is around a scene in place of a planet.
struct Studio {
    glm::dvec3 fill{0};     ///< irradiance of an even light from all sides, relative to the sun's
    glm::dvec3 backdrop{0}; ///< radiance of what is behind the scene
};

/// A view with everything looked up: what the renderer draws.
struct World {
    Planet planet;
    Camera camera;
    glm::dvec3 to_sun{0, 0, 1}; ///< unit, world
    std::optional<Studio> studio{}; ///< where given, the planet has no body and no air: only its sun shines
};

/// Throws Error(bad_input) where the camera is inside the planet.
World make_world(View const& view, Planet const& planet);

/// A list of timed views over one planet and scene (assets/flight.schema.json), with interpolation that is smooth over
/// seven orders of magnitude of altitude: log-altitude, great circles, quaternion headings; monotone cubics in time.
struct Flight {
    std::string name;
    View base{}; ///< planet, scene, placement, settings
    struct Key {
        double time = 0; ///< [s]
        CameraPlace camera;
        SunPlace sun;
        double exposure = 0; ///< [stops]
    };
    std::vector<Key> keys{}; ///< at least two, times increasing from 0
    double ground = 0;       ///< [m] altitude at which the logarithm of the height starts

    double duration() const { return keys.back().time; }
    /// The view at a time, clamped to the flight. Its sun is the same direction in the world as that of the keys.
    View at(double time) const;
};

Flight load_flight(std::filesystem::path const& file);

} // namespace alpenglow
