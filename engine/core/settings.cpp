#include "core/settings.h"

#include "core/error.h"
#include "core/suggestion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace alpenglow {

namespace {

constexpr double NO_LIMIT = std::numeric_limits<double>::infinity();

constexpr std::array TABLE{
    SettingInfo{.name = "air", .member = &Settings::air, .help = "the air's in-scattered light and extinction"},
    SettingInfo{.name = "model", .member = &Settings::model, .choices = "march|naive|tables",
                .help = "how the air is lit: docs/adding_a_model.md"},
    SettingInfo{.name = "air_without", .member = &Settings::air_without,
                .help = "names of the air's components that are switched off, commas between them"},
    SettingInfo{.name = "air_phases", .member = &Settings::air_phases,
                .help = "phases in place of the planet's: NAME=KIND:NUMBERS, such as `aerosol=henyey_greenstein:0.76`, "
                        "commas between them"},
    SettingInfo{.name = "samples", .member = &Settings::samples, .smallest = 4, .largest = 1024,
                .help = "march samples for each pixel"},
    SettingInfo{.name = "shafts", .member = &Settings::shafts, .choices = "off|fast|default|exact",
                .help = "light shafts, and their quality: docs/shafts.md"},
    SettingInfo{.name = "exact_steps", .member = &Settings::exact_steps, .smallest = 4, .largest = 6400,
                .help = "with shafts=exact: even steps of each pixel's ray where meshes can shade the air"},
    SettingInfo{.name = "soft_shafts", .member = &Settings::soft_shafts,
                .help = "shafts have the penumbra of the sun's disc; off: of a point, but for shadows beyond shadow_reach"},
    SettingInfo{.name = "air_stride", .member = &Settings::air_stride, .choices = "auto|1|2|4", .unit = "pixels",
                .help = "from one marched ray to the next; between them the air is interpolated where it is smooth, and "
                        "marched where it is not. auto: 1 with shafts=exact, else 4"},
    SettingInfo{.name = "multiple_scattering", .member = &Settings::multiple_scattering,
                .help = "light that the air scatters more than once"},
    SettingInfo{.name = "spread_tables", .member = &Settings::spread_tables,
                .help = "spread the making of the air's tables over frames; off: a picture is of finished tables"},
    SettingInfo{.name = "march_dither", .member = &Settings::march_dither,
                .help = "offset the march's samples from pixel to pixel, the same way in every picture"},
    SettingInfo{.name = "sun_disc", .member = &Settings::sun_disc, .help = "the sun's disc in the sky"},
    SettingInfo{.name = "stars", .member = &Settings::stars, .help = "the stars behind the air"},
    SettingInfo{.name = "shadows", .member = &Settings::shadows, .help = "the sun's shadows on surfaces"},
    SettingInfo{.name = "cascades", .member = &Settings::cascades, .smallest = 1, .largest = 4,
                .help = "shadow maps, one beyond the other"},
    SettingInfo{.name = "cascade_size", .member = &Settings::cascade_size, .smallest = 256, .largest = 8192,
                .unit = "texels", .help = "side of a shadow map"},
    SettingInfo{.name = "shadow_reach", .member = &Settings::shadow_reach, .smallest = 1e2, .largest = 1e7,
                .unit = "m", .help = "distance to which shadow maps reach"},
    SettingInfo{.name = "ceiling_size", .member = &Settings::ceiling_size, .smallest = 0, .largest = 8192,
                .unit = "texels",
                .help = "side of the map that shades air and ground beyond shadow_reach; 0: nothing is shaded there"},
    SettingInfo{.name = "terrain_light_size", .member = &Settings::terrain_light_size, .smallest = 0, .largest = 2048,
                .unit = "texels",
                .help = "side of the map of the light from all round on terrain, which hides the sky from itself and "
                        "lights itself; 0: as on level ground"},
    SettingInfo{.name = "ambient_occlusion", .member = &Settings::ambient_occlusion,
                .help = "surfaces hide the sky from each other"},
    SettingInfo{.name = "exposure", .member = &Settings::exposure, .smallest = -32, .largest = 32, .unit = "stops",
                .help = "displayed = curve(2^exposure * radiance)"},
    SettingInfo{.name = "auto_exposure", .member = &Settings::auto_exposure,
                .help = "exposure follows the picture's luminance; the setting exposure is not used"},
    SettingInfo{.name = "exposure_compensation", .member = &Settings::exposure_compensation, .smallest = -16,
                .largest = 16, .unit = "stops", .help = "added to what auto_exposure finds"},
    SettingInfo{.name = "exposure_least", .member = &Settings::exposure_least, .smallest = -32, .largest = 32,
                .unit = "stops", .help = "lower bound of auto_exposure"},
    SettingInfo{.name = "exposure_most", .member = &Settings::exposure_most, .smallest = -32, .largest = 32,
                .unit = "stops", .help = "upper bound of auto_exposure: night stays dark"},
    SettingInfo{.name = "light_adaptation", .member = &Settings::light_adaptation, .smallest = 0.01, .largest = 100,
                .unit = "stops/s", .help = "how fast auto_exposure follows a picture that grows brighter"},
    SettingInfo{.name = "dark_adaptation", .member = &Settings::dark_adaptation, .smallest = 0.01, .largest = 100,
                .unit = "stops/s", .help = "how fast auto_exposure follows a picture that grows darker"},
    SettingInfo{.name = "curve", .member = &Settings::curve, .choices = "filmic|exponential|reinhard|aces|lottes|uchimura|agx|linear",
                .help = "from linear light to the display"},
    SettingInfo{.name = "dither", .member = &Settings::dither, .help = "dither after the curve, before 8 bits"},
    SettingInfo{.name = "aa", .member = &Settings::aa, .choices = "1|4|16",
                .help = "supersampling: rays for each pixel"},
    SettingInfo{.name = "post_aa", .member = &Settings::post_aa, .choices = "none|fxaa",
                .help = "antialiasing filter on the finished picture"},
    SettingInfo{.name = "show", .member = &Settings::show,
                .help = "name of an image of the frame to show in place of the result; empty: the result"},
    SettingInfo{.name = "largest_texture", .member = &Settings::largest_texture, .smallest = 16, .largest = 16384,
                .unit = "texels", .help = "side beyond which a scene's pictures are scaled down at import"},
    SettingInfo{.name = "largest_scene_file", .member = &Settings::largest_scene_file, .smallest = 1, .largest = 65536,
                .unit = "MiB", .help = "limit for a scene's file, and for all that it names or unpacks"},
    SettingInfo{.name = "most_json_values", .member = &Settings::most_json_values, .smallest = 1e3, .largest = 1e8,
                .help = "limit for the values in a scene's JSON"},
    SettingInfo{.name = "most_entries", .member = &Settings::most_entries, .smallest = 1e3, .largest = 1e8,
                .help = "limit for each of a scene's lists: nodes, meshes, accessors, …"},
    SettingInfo{.name = "most_materials", .member = &Settings::most_materials, .smallest = 1, .largest = 1e6,
                .help = "limit for a scene's materials"},
    SettingInfo{.name = "deepest_json", .member = &Settings::deepest_json, .smallest = 16, .largest = 1000,
                .unit = "levels", .help = "limit for the nesting of a scene's JSON"},
    SettingInfo{.name = "deepest_node", .member = &Settings::deepest_node, .smallest = 1, .largest = 1e6,
                .unit = "levels", .help = "limit for how deep a scene's nodes stand below each other"},
    SettingInfo{.name = "most_instances", .member = &Settings::most_instances, .smallest = 1, .largest = 1e8,
                .help = "limit for the meshes that a scene places"},
    SettingInfo{.name = "most_vertices", .member = &Settings::most_vertices, .smallest = 3, .largest = 1e9,
                .help = "limit for the vertices of a scene's meshes in all"},
    SettingInfo{.name = "most_indices", .member = &Settings::most_indices, .smallest = 3, .largest = 2e9,
                .help = "limit for the indices of a scene's meshes in all"},
    SettingInfo{.name = "most_triangles", .member = &Settings::most_triangles, .smallest = 1, .largest = 2e9,
                .help = "limit for the triangles that a scene draws, those of a mesh once for each instance"},
    SettingInfo{.name = "largest_picture", .member = &Settings::largest_picture, .smallest = 1, .largest = 65535,
                .unit = "texels", .help = "limit for the side of a scene's picture, before it is scaled down"},
    SettingInfo{.name = "most_pixels", .member = &Settings::most_pixels, .smallest = 1, .largest = 4096,
                .unit = "Mi texels", .help = "limit for the texels of a scene's picture, before it is scaled down"},
    SettingInfo{.name = "most_picture_memory", .member = &Settings::most_picture_memory, .smallest = 1,
                .largest = 1048576, .unit = "MiB",
                .help = "limit for the memory of a scene's pictures in all, after scaling, without mipmaps"},
};

bool is_choice(std::string_view choices, std::string_view value) {
    while (!choices.empty()) {
        std::size_t const bar = std::min(choices.find('|'), choices.size());
        if (choices.substr(0, bar) == value) return true;
        choices.remove_prefix(std::min(bar + 1, choices.size()));
    }
    return false;
}

/// The whole text as a number, or nothing.
template <typename Number> std::optional<Number> parse_number(std::string_view text) {
    Number number{};
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<bool> parse_switch(std::string_view text) {
    if (text == "on" || text == "true") return true;
    if (text == "off" || text == "false") return false;
    return std::nullopt;
}

/// The text as the type that `info` has, or nothing.
std::optional<SettingValue> parse_value(SettingInfo const& info, std::string_view text) {
    auto const wrap = [](auto const& parsed) { return parsed ? std::optional<SettingValue>(*parsed) : std::nullopt; };
    switch (info.member.index()) {
    case 0: return wrap(parse_switch(text));
    case 1: return wrap(parse_number<int>(text));
    case 2: return wrap(parse_number<double>(text));
    default: return SettingValue(std::string(text));
    }
}

SettingInfo const& require_setting(std::string_view name) {
    if (SettingInfo const* const info = find_setting(name)) return *info;
    std::vector<std::string_view> names;
    for (SettingInfo const& info : TABLE) names.push_back(info.name);
    std::string advice = suggestion(name, names);
    if (advice.empty()) advice = fmt::format("the settings are {}", fmt::join(names, ", "));
    throw Error(ErrorKind::wrong_use, fmt::format("there is no setting \"{}\"", name), {}, advice);
}

} // namespace

std::span<SettingInfo const> setting_table() { return TABLE; }

SettingInfo const* find_setting(std::string_view name) {
    auto const found = std::ranges::find(TABLE, name, &SettingInfo::name);
    return found == TABLE.end() ? nullptr : &*found;
}

void set_setting(Settings& settings, std::string_view name, std::string_view text) {
    SettingInfo const& info = require_setting(name);
    std::optional<SettingValue> const value = parse_value(info, text);
    if (!value || !in_range(info, *value)) {
        throw Error(ErrorKind::wrong_use, fmt::format("\"{}\" is no value for it", text),
                    fmt::format("setting {}", info.name), "give " + range_text(info));
    }
    set_setting(settings, info, *value);
}

void set_setting(Settings& settings, SettingInfo const& info, SettingValue const& value) {
    auto const assign = [&](auto member) {
        auto& field = settings.*member;
        field = std::get<std::remove_reference_t<decltype(field)>>(value);
    };
    std::visit(assign, info.member);
}

std::string range_text(SettingInfo const& info) {
    std::string const unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
    if (!info.choices.empty()) return std::string(info.choices);
    if (std::holds_alternative<bool Settings::*>(info.member)) return "on or off";
    if (std::holds_alternative<std::string Settings::*>(info.member)) return "a text";
    if (info.smallest == -NO_LIMIT && info.largest == NO_LIMIT) return "a number" + unit;
    return fmt::format("{} to {}{}", info.smallest, info.largest, unit);
}

std::vector<std::string> choices_of(SettingInfo const& info) {
    std::vector<std::string> result;
    for (std::string_view rest = info.choices; !rest.empty();) {
        std::size_t const bar = std::min(rest.find('|'), rest.size());
        result.emplace_back(rest.substr(0, bar));
        rest.remove_prefix(std::min(bar + 1, rest.size()));
    }
    return result;
}

bool in_range(SettingInfo const& info, SettingValue const& value) {
    if (auto const* const text = std::get_if<std::string>(&value)) {
        return info.choices.empty() || is_choice(info.choices, *text);
    }
    if (std::holds_alternative<bool>(value)) return true;
    int const* const whole = std::get_if<int>(&value);
    if (whole && !info.choices.empty()) return is_choice(info.choices, std::to_string(*whole));
    double const number = whole ? *whole : std::get<double>(value);
    return std::isfinite(number) && number >= info.smallest && number <= info.largest;
}

SettingValue get_setting(Settings const& settings, SettingInfo const& info) {
    return std::visit([&](auto member) { return SettingValue(settings.*member); }, info.member);
}

std::string setting_text(Settings const& settings, SettingInfo const& info) {
    SettingValue const value = get_setting(settings, info);
    if (bool const* const on = std::get_if<bool>(&value)) return *on ? "on" : "off";
    if (auto const* const text = std::get_if<std::string>(&value)) return *text;
    if (int const* const whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
    return fmt::format("{}", std::get<double>(value)); // the shortest text that reads back as the same number
}

} // namespace alpenglow
