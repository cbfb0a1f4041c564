#include "image/color.h"

#include <cmath>
#include <limits>
#include <vector>

namespace alpenglow {

namespace {

template <class Value> Value stored_from_unit(float value) {
    constexpr float greatest = std::numeric_limits<Value>::max();
    return value > 0 ? static_cast<Value>(std::lround(greatest * std::fmin(value, 1.0f))) : Value{0};
}

/// Of every value that a channel can have.
template <class Value> std::vector<float> make_decoding_table() {
    constexpr std::size_t greatest = std::numeric_limits<Value>::max();
    std::vector<float> table(greatest + 1);
    for (std::size_t i = 0; i <= greatest; ++i)
        table[i] = linear_from_srgb(static_cast<float>(i) / static_cast<float>(greatest));
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
    static std::vector<float> const table = make_decoding_table<std::uint8_t>();
    return table[encoded];
}

std::uint8_t srgb_byte_from_linear(float linear) { return stored_from_unit<std::uint8_t>(srgb_from_linear(linear)); }

float linear_from_srgb_word(std::uint16_t encoded) {
    static std::vector<float> const table = make_decoding_table<std::uint16_t>();
    return table[encoded];
}

std::uint16_t srgb_word_from_linear(float linear) { return stored_from_unit<std::uint16_t>(srgb_from_linear(linear)); }

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
        float const value = image.rgba[i];
        result.rgba[i] = i % 4 == 3 ? stored_from_unit<std::uint8_t>(value) : srgb_byte_from_linear(value);
    }
    return result;
}

} // namespace alpenglow
