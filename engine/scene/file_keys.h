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
inline constexpr NumberKey WAVELENGTH{"", 360e-9, 830e-9, "a wavelength in metres"};
inline constexpr NumberKey AIR_DENSITY{"air_density", 0, 1e3,
                                       "Rayleigh scattering of air, whose density is in units of Earth's at sea level"};
inline constexpr NumberKey OZONE_COLUMN{"ozone_column", 0, 1e5,
                                        "absorption of ozone, whose column over the ground is in Dobson units"};
inline constexpr NumberKey ASYMMETRY{"g", -0.99, 0.99, "the asymmetry of the phase; positive is forwards"};
inline constexpr NumberKey SECOND_ASYMMETRY{"second_g", -0.99, 0.99, "the asymmetry of the second lobe"};
inline constexpr NumberKey SECOND_WEIGHT{"second_weight", 0, 1, "the share of the second lobe"};
inline constexpr NumberKey DIAMETER{"diameter", 5e-6, 5e-5, "the diameter of water droplets in metres"};
inline constexpr std::array<std::string_view, 6> PHASE_KINDS{
    "isotropic", "rayleigh", "henyey_greenstein", "double_henyey_greenstein", "cornette_shanks", "droplets"};
inline constexpr NumberKey SCALE_HEIGHT{"scale_height", 1, 1e7,
                                        "the altitude in metres over which density falls to 1/e"};
inline constexpr NumberKey TENT_CENTRE{"centre", 0, 1e8, "the altitude in metres of the tent's peak"};
inline constexpr NumberKey TENT_HALF_WIDTH{"half_width", 1, 1e8, "how far in metres the tent reaches from its centre"};
inline constexpr NumberKey SHELL_BOTTOM{"bottom", 0, 1e8, "the altitude in metres where the shell begins"};
inline constexpr NumberKey SHELL_TOP{"top", 0, 1e8, "the altitude in metres where the shell ends"};
inline constexpr NumberKey NODE_ALTITUDE{"", 0, 1e8, "an altitude in metres"};
inline constexpr NumberKey NODE_DENSITY{"", 0, 1e3, "a density, the share of the coefficients"};
inline constexpr std::array<std::string_view, 4> PROFILE_KINDS{"exponential", "tent", "shell", "table"};
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
