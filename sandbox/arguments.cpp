#include "sandbox/arguments.h"

#include "core/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <vector>

namespace alpenglow {

namespace {

constexpr long SMALLEST_SIDE = 16, LARGEST_SIDE = 16384; // [pixels]
constexpr double LARGEST_ALTITUDE = 1e9;                 // [m]

[[noreturn]] void refuse(std::string_view option, std::string_view text, std::string const& wanted) {
    throw Error(ErrorKind::wrong_use, fmt::format("{} '{}' can't be used", option, text), {}, "give " + wanted);
}

template <class Number> std::optional<Number> whole_text(std::string_view text) {
    Number value{};
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool finite_within(std::optional<double> value, double smallest, double largest) {
    return value && std::isfinite(*value) && *value >= smallest && *value <= largest;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end = 0; end != std::string_view::npos;) {
        end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end != std::string_view::npos) text.remove_prefix(end + 1);
    }
    return parts;
}

double radians(double degrees) { return degrees * (M_PI / 180); }

} // namespace

double parse_number(std::string_view option, std::string_view text, double smallest, double largest) {
    auto const value = whole_text<double>(text);
    if (!finite_within(value, smallest, largest))
        refuse(option, text, fmt::format("a number from {} to {}", smallest, largest));
    return *value;
}

long parse_integer(std::string_view option, std::string_view text, long smallest, long largest) {
    auto const value = whole_text<long>(text);
    if (!value || *value < smallest || *value > largest) {
        refuse(option, text, fmt::format("a whole number from {} to {}", smallest, largest));
    }
    return *value;
}

Extent parse_size(std::string_view option, std::string_view text) {
    auto const parts = split(text, 'x');
    auto const side = [](std::string_view digits) -> std::uint32_t {
        auto const value = whole_text<long>(digits);
        return value && *value >= SMALLEST_SIDE && *value <= LARGEST_SIDE ? static_cast<std::uint32_t>(*value) : 0;
    };
    Extent const extent = parts.size() == 2 ? Extent{side(parts[0]), side(parts[1])} : Extent{};
    if (extent.pixels() == 0) {
        refuse(option, text,
               fmt::format("WIDTHxHEIGHT such as 1280x720, each from {} to {}", SMALLEST_SIDE, LARGEST_SIDE));
    }
    return extent;
}

Geodetic parse_place(std::string_view option, std::string_view text) {
    auto const parts = split(text, ',');
    auto const number = [&](std::size_t i) { return i < parts.size() ? whole_text<double>(parts[i]) : 0.0; };
    if (parts.size() < 2 || parts.size() > 3 || !finite_within(number(0), -90, 90) ||
        !finite_within(number(1), -180, 360) || !finite_within(number(2), -LARGEST_ALTITUDE, LARGEST_ALTITUDE)) {
        refuse(option, text, "LATITUDE,LONGITUDE[,ALTITUDE] in degrees and metres, such as 46.5,8.0,1200");
    }
    return {radians(*number(0)), radians(*number(1)), *number(2)};
}

Override parse_override(std::string_view option, std::string_view text) {
    std::size_t const equals = text.find('=');
    if (equals == 0 || equals == std::string_view::npos) refuse(option, text, "NAME=VALUE, such as samples=64");
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::size_t parse_choice(std::string_view option, std::string_view text,
                         std::initializer_list<std::string_view> choices) {
    auto const found = std::ranges::find(choices, text);
    if (found == choices.end()) refuse(option, text, fmt::format("{}", fmt::join(choices, " or ")));
    return static_cast<std::size_t>(found - choices.begin());
}

PictureFormats parse_formats(std::string_view option, std::string_view text) {
    PictureFormats formats;
    for (std::string_view const part : split(text, ',')) {
        if (part == "png") {
            formats.png = true;
        } else if (part == "exr") {
            formats.exr = true;
        } else {
            refuse(option, text, "png, exr or png,exr");
        }
    }
    return formats;
}

} // namespace alpenglow
