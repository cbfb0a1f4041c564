#include "image/heat_map.h"

#include "image/bitmap_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace alpenglow {

namespace {

/// Every 17th of magma's 256 colours; between them it is straight to within 3/255.
constexpr std::array<std::uint32_t, 16> MAGMA{0x000004, 0x0b0924, 0x20114b, 0x3b0f70, 0x57157e, 0x721f81,
                                              0x8c2981, 0xa8327d, 0xc43c75, 0xde4968, 0xf1605d, 0xfa7f5e,
                                              0xfe9f6d, 0xfebf84, 0xfddea0, 0xfcfdbf};

constexpr std::uint32_t TEXT_COLOR = 0xd0d0d0;
constexpr std::uint8_t GROUND = 24; // sRGB grey
constexpr int GAP = 4;              // [pixels] around the bar and its numbers
constexpr std::uint32_t WIDE = 480; // [pixels] room for numbers of double size

float channel(std::uint32_t color, int shift) { return static_cast<float>((color >> shift) & 0xff); }

void put(ByteImage& picture, std::uint32_t x, std::uint32_t y, std::uint32_t color) {
    std::uint8_t* const p = picture.at(x, y);
    p[0] = static_cast<std::uint8_t>(color >> 16), p[1] = static_cast<std::uint8_t>(color >> 8);
    p[2] = static_cast<std::uint8_t>(color), p[3] = 255;
}

void draw_bar(ByteImage& picture, std::uint32_t top, std::uint32_t height) {
    std::uint32_t const width = picture.extent.width;
    for (std::uint32_t x = 0; x < width; ++x) {
        std::uint32_t const color = magma((static_cast<float>(x) + 0.5f) / static_cast<float>(width));
        for (std::uint32_t y = top; y < top + height; ++y) put(picture, x, y, color);
    }
}

/// Each number centred below its place on the bar, the outer ones moved inside.
void draw_numbers(ByteImage& picture, int top, int scale) {
    constexpr std::array<std::string_view, 6> numbers{"0", "0.2", "0.4", "0.6", "0.8", "1"};
    int const width = static_cast<int>(picture.extent.width);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        int const text = text_width(numbers[i], scale), centre = static_cast<int>(i) * width / 5;
        int const left = std::clamp(centre - text / 2, GAP, std::max(width - text - GAP, GAP));
        draw_text(picture, left, top, numbers[i], TEXT_COLOR, scale);
    }
}

} // namespace

std::uint32_t magma(float value) {
    float const at = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(MAGMA.size() - 1);
    std::size_t const i = std::min(static_cast<std::size_t>(at), MAGMA.size() - 2);
    std::uint32_t color = 0;
    for (int const shift : {16, 8, 0}) {
        float const mixed =
            std::lerp(channel(MAGMA[i], shift), channel(MAGMA[i + 1], shift), at - static_cast<float>(i));
        color |= static_cast<std::uint32_t>(std::lround(mixed)) << shift;
    }
    return color;
}

ByteImage heat_map(FlipResult const& flip) {
    int const scale = flip.extent.width >= WIDE ? 2 : 1;
    auto const bar = static_cast<std::uint32_t>(10 * scale);
    auto const legend = static_cast<std::uint32_t>(3 * GAP + TEXT_LINE_HEIGHT * scale) + bar;
    ByteImage picture({flip.extent.width, flip.extent.height + legend});
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : GROUND;
    for (std::uint32_t y = 0; y < flip.extent.height; ++y) {
        for (std::uint32_t x = 0; x < flip.extent.width; ++x) {
            put(picture, x, y, magma(flip.error[std::size_t{y} * flip.extent.width + x]));
        }
    }
    draw_bar(picture, flip.extent.height + GAP, bar);
    draw_numbers(picture, static_cast<int>(flip.extent.height + bar) + 2 * GAP, scale);
    return picture;
}

} // namespace alpenglow
