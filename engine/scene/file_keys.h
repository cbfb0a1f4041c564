#pragma once

#include "core/settings.h"
#include "scene/json_reader.h"

#include <array>

/// The numbers in planet, view and flight files: name, range and meaning. Readers, writers and schemas are made from
/// it. Angles are in degrees in files.
namespace alpenglow::json {

inline constexpr NumberKey RADIUS{"radius", 1e3, 1e9, "the reference radius (\"sea level\") in metres"};
inline constexpr NumberKey TOP_ALTITUDE{"top_altitude", 1, 1e8, "the altitude in metres beyond which there is no air"};
inline constexpr NumberKey COEFFICIENT{"", 0, 1, "a coefficient in 1/m"};
inline constexpr NumberKey SCALE_HEIGHT{"scale_height", 1, 1e7,
                                        "the altitude in metres over which density falls to 1/e"};
inline constexpr NumberKey ASYMMETRY{"g", -0.99, 0.99, "the asymmetry of the aerosol's Cornette-Shanks phase"};
inline constexpr NumberKey OZONE_CENTRE{"centre", 0, 1e8, "the altitude in metres of the tent's peak"};
inline constexpr NumberKey OZONE_HALF_WIDTH{"half_width", 1, 1e8, "how far in metres the tent reaches from its centre"};
inline constexpr NumberKey ALBEDO{"albedo", 0, 1, "the share of light that the ground gives back"};
inline constexpr NumberKey IRRADIANCE{"irradiance", 0, 1e6, "the sun's irradiance above the air, relative"};
inline constexpr NumberKey SUN_RADIUS{"angular_radius", 0, 45, "the sun's angular radius in degrees", true};

inline constexpr NumberKey LATITUDE{"latitude", -90, 90, "degrees, north positive"};
inline constexpr NumberKey LONGITUDE{"longitude", -360, 360, "degrees, east positive"};
inline constexpr NumberKey CAMERA_ALTITUDE{"altitude", 0, 1e9, "metres above the planet's reference radius", true};
inline constexpr NumberKey HEADING{"heading", -360, 360, "degrees, clockwise from north", false, 0.0};
inline constexpr NumberKey PITCH{"pitch", -90, 90, "degrees, upwards positive", false, 0.0};
inline constexpr NumberKey ROLL{"roll", -360, 360, "degrees, clockwise as the pilot sees it", false, 0.0};
inline constexpr NumberKey FOV{"fov", 1, 170, "the vertical field of view in degrees", false, 60.0};
inline constexpr std::array CAMERA_KEYS{LATITUDE, LONGITUDE, CAMERA_ALTITUDE, HEADING, PITCH, ROLL, FOV};

inline constexpr NumberKey ELEVATION{"elevation", -90, 90, "degrees above the horizon"};
inline constexpr NumberKey AZIMUTH{"azimuth", -360, 360, "degrees, clockwise from north"};

inline constexpr NumberKey ANCHOR_ALTITUDE{"altitude", -1e4, 1e7, "metres above the planet's reference radius",
                                           false,      0.0};
inline constexpr NumberKey YAW{"yaw", -360, 360, "degrees clockwise seen from above", false, 0.0};
inline constexpr NumberKey SCALE{"scale", 1e-6, 1e6, "metres for a unit of the scene", false, 1.0};

inline constexpr NumberKey SCENE_INDEX{"index", 0, 1e6, "which of the file's scenes; its default where left out"};

inline constexpr NumberKey TIME{"time", 0, 1e6, "seconds from the start of the flight"};
inline constexpr NumberKey GROUND{"ground", 0, 1e9, "altitude in metres from which climbs are logarithmic", false, 0.0};

/// A setting that is a real number, as a key.
inline NumberKey setting_key(SettingInfo const& info) { return {info.name, info.smallest, info.largest, info.help}; }

} // namespace alpenglow::json
