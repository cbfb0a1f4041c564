#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace alpenglow {

/// Everything about a picture that is not the world itself. One table (`setting_table`) gives each field its name,
/// type, range, unit and help; the command line, the view files and their schema, the panel and the documents are made
/// from it.
struct Settings {
    // The air
    bool air = true;                 ///< the air's in-scattered light and extinction
    std::string model = "march";     ///< how the air is lit: render/models
    std::string air_without{};       ///< components of the planet's air that are left out
    std::string air_phases{};        ///< phases other than the planet's, NAME=PHASE
    int samples = 32;                ///< march samples for each pixel, 4 to 1024
    int exact_steps = 1600;          ///< of shafts "exact" where the air can be shaded
    std::string shafts = "default";  ///< shadows in the air: off | fast | default | exact
    std::string air_stride = "auto"; ///< [pixels] from one marched ray to the next: auto | 1 | 2 | 4
    bool multiple_scattering = true; ///< light scattered more than once
    bool spread_tables = false;      ///< over frames; else a picture is of finished tables
    bool march_dither = false;       ///< deterministic offset of the march's samples from pixel to pixel
    bool soft_shafts = false;        ///< shadows in the air have the penumbra of the sun's disc
    bool sun_disc = true;
    bool stars = true;

    // Shadows
    bool shadows = true;
    bool ambient_occlusion = true;
    int cascades = 4;          ///< 1 to 4
    int cascade_size = 2048;   ///< texels along a side, 256 to 8192
    int ceiling_size = 2048;   ///< [texels] along a side of the shadow ceiling's map; 0: no shadow beyond shadow_reach
    int terrain_light_size = 256; ///< [texels] along a side of the map of the light on terrain; 0: as on level ground
    double shadow_reach = 2e4; ///< [m]

    // The picture
    double exposure = 0.0;        ///< [stops]; displayed = curve(2^exposure * radiance)
    bool auto_exposure = false;   ///< follows the picture's luminance in place of `exposure`
    double exposure_compensation = 0.0; ///< [stops] more than auto_exposure finds
    double exposure_least = -14.0, exposure_most = 20.0;          ///< [stops] bounds of auto_exposure
    double light_adaptation = 3.0, dark_adaptation = 1.5;         ///< [stops/s] at most
    std::string curve = "filmic"; ///< from linear light to the display: encoding/tone_curves.glsl
    bool dither = true;           ///< after the curve, before 8 bits
    int aa = 1;                   ///< supersampling: 1, 4 or 16
    std::string post_aa = "none"; ///< none | fxaa
    std::string show{};           ///< name of a frame image to show in place of the result

    // Scenes
    int largest_texture = 4096; ///< [texels] larger pictures are scaled down at import

    // What a scene may ask for; beyond, it is refused
    int largest_scene_file = 4096; ///< [MiB]
    int most_json_values = 8'000'000;
    int most_entries = 1'000'000;
    int most_materials = 65536;
    int deepest_json = 100;
    int deepest_node = 500;
    int most_instances = 1'000'000;
    int most_vertices = 16 << 20;
    int most_indices = 192 << 20;
    int largest_picture = 16384; ///< [texels]
    int most_triangles = 64 << 20;
    int most_pixels = 128;          ///< [Mi texels]
    int most_picture_memory = 4096; ///< [MiB]

    bool operator==(Settings const&) const = default;
};

/// Where a setting lives in `Settings`.
using SettingMember = std::variant<bool Settings::*, int Settings::*, double Settings::*, std::string Settings::*>;

struct SettingInfo {
    std::string_view name;
    SettingMember member;
    double smallest = -std::numeric_limits<double>::infinity();
    double largest = std::numeric_limits<double>::infinity();
    std::string_view choices{}; ///< "a|b|c" for a text or for an int that takes only these values; empty: anything
    std::string_view unit{};
    std::string_view help{};
};

/// The value of any setting.
using SettingValue = std::variant<bool, int, double, std::string>;

std::span<SettingInfo const> setting_table();
/// nullptr where there is none of that name.
SettingInfo const* find_setting(std::string_view name);
/// From the command line: `value` as text ("on", "off", "true", "false" for switches). Throws Error(wrong_use).
void set_setting(Settings& settings, std::string_view name, std::string_view value);
/// `value` has the setting's own type and is in its range.
void set_setting(Settings& settings, SettingInfo const& info, SettingValue const& value);
/// The values that a setting takes, in words: "on or off", "4 to 1024", "1|4|16".
std::string range_text(SettingInfo const& info);
/// The values of a setting that has choices, one by one.
std::vector<std::string> choices_of(SettingInfo const& info);
/// Whether a value of the setting's own type is one of those.
bool in_range(SettingInfo const& info, SettingValue const& value);
SettingValue get_setting(Settings const& settings, SettingInfo const& info);
/// The value as text, as set_setting takes it.
std::string setting_text(Settings const& settings, SettingInfo const& info);

} // namespace alpenglow
