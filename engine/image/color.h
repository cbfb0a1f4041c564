#pragma once

#include "image/image.h"

#include <cstdint>

namespace alpenglow {

/// The exact piecewise sRGB curve (IEC 61966-2-1), 0..1 to 0..1; not clamped.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

/// The same for bytes: by table, and rounded to nearest with values outside 0..1 (and NaN, as 0) clamped.
float linear_from_srgb_byte(std::uint8_t encoded);
std::uint8_t srgb_byte_from_linear(float linear);
/// The same for 16 bits.
float linear_from_srgb_word(std::uint16_t encoded);
std::uint16_t srgb_word_from_linear(float linear);

/// Relative luminance of linear Rec.709 (ITU-R BT.709-6, section 3.2).
constexpr float luminance(float red, float green, float blue) {
    return 0.2126f * red + 0.7152f * green + 0.0722f * blue;
}

/// Linear light 0..1 as a screen shows radiance through the exponential curve: 1 - exp(-2^exposure * L). `exposure` is
/// in stops. What is not finite stays as it is, and so does alpha.
FloatImage exponential_display(FloatImage const& radiance, double exposure);

/// Alpha is linear in both and only scaled.
FloatImage linear_from_srgb(ByteImage const& image);
ByteImage srgb_from_linear(FloatImage const& image);

} // namespace alpenglow
