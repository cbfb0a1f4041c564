#include "image/color.h"
#include "image/heat_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace alpenglow;

namespace {

std::uint32_t color_at(ByteImage const& picture, std::uint32_t x, std::uint32_t y) {
    std::uint8_t const* const p = picture.at(x, y);
    return (std::uint32_t{p[0]} << 16) | (std::uint32_t{p[1]} << 8) | p[2];
}

float luminance_of(std::uint32_t color) {
    auto const linear = [&](int shift) { return linear_from_srgb_byte(static_cast<std::uint8_t>(color >> shift)); };
    return luminance(linear(16), linear(8), linear(0));
}

FlipResult ramp(Extent extent) {
    FlipResult flip;
    flip.extent = extent;
    for (std::size_t i = 0; i < extent.pixels(); ++i)
        flip.error.push_back(static_cast<float>(i) / static_cast<float>(extent.pixels() - 1));
    return flip;
}

} // namespace

/// The first, the middle and the last of matplotlib's 256 colours.
TEST(Magma, has_the_colours_of_matplotlib) {
    EXPECT_EQ(magma(0), 0x000004u);
    EXPECT_EQ(magma(1), 0xfcfdbfu);
    EXPECT_EQ(magma(119.0f / 255), 0xa8327du);
    EXPECT_EQ(magma(-1), magma(0));
    EXPECT_EQ(magma(2), magma(1));
    // Number 128 is between two that are kept.
    std::uint32_t const between = magma(128.0f / 255);
    for (auto const& [shift, wanted] : {std::pair{16, 0.716387}, std::pair{8, 0.214982}, std::pair{0, 0.475290}})
        EXPECT_NEAR((between >> shift) & 0xff, 255 * wanted, 3);
}

/// L* grows evenly: the scale is perceptually uniform.
TEST(Magma, grows_evenly_in_lightness) {
    auto const lightness = [](float value) { return 116 * std::cbrt(luminance_of(magma(value))) - 16; };
    for (float value = 0.1f; value < 0.95f; value += 0.1f) {
        EXPECT_NEAR(lightness(value + 0.05f) - lightness(value - 0.05f), 10, 2) << value;
    }
}

TEST(HeatMap, shows_each_pixel_and_the_scale_below) {
    FlipResult const flip = ramp({320, 180});
    ByteImage const map = heat_map(flip);
    ASSERT_EQ(map.extent.width, 320u);
    ASSERT_GT(map.extent.height, 180u + 20u);
    for (std::uint32_t const y : {0u, 90u, 179u}) EXPECT_EQ(color_at(map, 7, y), magma(flip.error[y * 320 + 7]));

    std::uint32_t const bar = 180 + 8; // in its middle
    EXPECT_EQ(color_at(map, 0, bar), magma(0.5f / 320));
    EXPECT_EQ(color_at(map, 319, bar), magma(319.5f / 320));

    int bright = 0;
    for (std::uint32_t y = 180 + 16; y < map.extent.height; ++y) {
        for (std::uint32_t x = 0; x < 320; ++x) bright += luminance_of(color_at(map, x, y)) > 0.4f;
    }
    EXPECT_GT(bright, 6 * 5) << "six numbers of a few pixels each";
}

TEST(HeatMap, of_a_very_small_picture_is_drawn_too) { EXPECT_EQ(heat_map(ramp({2, 2})).extent.width, 2u); }
