#include "image/color.h"

#include <array>
#include <cmath>

namespace alpenglow {

namespace {

std::uint8_t byte_from_unit(float value) {
    return value > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::fmin(value, 1.0f))) : std::uint8_t{0};
}

std::array<float, 256> make_decoding_table() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear_from_srgb(static_cast<float>(i) / 255);
    return table;
}

} // namespace

float srgb_from_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linear_from_srgb_byte(std::uint8_t encoded) {
    static std::array<float, 256> const table = make_decoding_table();
    return table[encoded];
}

std::uint8_t srgb_byte_from_linear(float linear) { return byte_from_unit(srgb_from_linear(linear)); }

FloatImage exponential_display(FloatImage const& radiance, double exposure) {
    auto const gain = static_cast<float>(std::exp2(exposure));
    FloatImage result = radiance;
    for (std::size_t i = 0; i < result.rgba.size(); ++i) {
        float& value = result.rgba[i];
        if (i % 4 != 3 && std::isfinite(value)) value = -std::expm1(-gain * value);
    }
    return result;
}

FloatImage linear_from_srgb(ByteImage const& image) {
    FloatImage result(image.extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        result.rgba[i] = i % 4 == 3 ? static_cast<float>(image.rgba[i]) / 255 : linear_from_srgb_byte(image.rgba[i]);
    }
    return result;
}

ByteImage srgb_from_linear(FloatImage const& image) {
    ByteImage result(image.extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        result.rgba[i] = i % 4 == 3 ? byte_from_unit(image.rgba[i]) : srgb_byte_from_linear(image.rgba[i]);
    }
    return result;
}

} // namespace alpenglow
