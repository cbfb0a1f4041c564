#pragma once

#include "sandbox/commands.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace alpenglow {

/// Texts of the command line as values. Each takes the whole text or throws Error(wrong_use), which names `option`,
/// says what was given and what is wanted. The locale plays no part.

/// A finite number from `smallest` to `largest`.
double parse_number(std::string_view option, std::string_view text, double smallest, double largest);
/// A whole number, in digits.
long parse_integer(std::string_view option, std::string_view text, long smallest, long largest);
/// WIDTHxHEIGHT, each 16 to 16384.
Extent parse_size(std::string_view option, std::string_view text);
/// LATITUDE,LONGITUDE[,ALTITUDE] in degrees and metres; degrees -90..90 and -180..360.
Geodetic parse_place(std::string_view option, std::string_view text);
/// NAME=VALUE; the value may be empty and may hold '='.
Override parse_override(std::string_view option, std::string_view text);

/// Which of `choices` the text is, from 0.
std::size_t parse_choice(std::string_view option, std::string_view text,
                         std::initializer_list<std::string_view> choices);

struct PictureFormats {
    bool png = false, exr = false;
};
/// png, exr, or both with a comma between them.
PictureFormats parse_formats(std::string_view option, std::string_view text);

} // namespace alpenglow
