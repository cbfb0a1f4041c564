#include "image/mipmaps.h"

#include "image/color.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace alpenglow;

namespace {

/// Something of everything: smooth, noisy, and all 256 bytes.
std::vector<std::uint8_t> texels(Extent extent) {
    std::vector<std::uint8_t> rgba;
    std::uint32_t noise = 1;
    for (std::size_t i = 0; i < extent.pixels() * 4; ++i) {
        noise = noise * 1664525 + 1013904223;
        rgba.push_back(static_cast<std::uint8_t>(i % 3 == 0 ? i : noise >> 24));
    }
    return rgba;
}

double light(std::uint8_t byte, bool srgb) { return srgb ? linear_from_srgb_byte(byte) : byte / 255.0; }
double encoded(double linear, bool srgb) { return 255 * (srgb ? srgb_from_linear(static_cast<float>(linear)) : linear); }

/// How much of a texel of `size` lies in texel `i` of half as many.
double share(std::uint32_t texel, std::uint32_t i, std::uint32_t size) {
    double const width = static_cast<double>(size) / std::max(size / 2, 1u);
    return std::max(0.0, std::min(texel + 1.0, (i + 1) * width) - std::max<double>(texel, i * width)) / width;
}

double mean_over_area(Extent from, std::vector<std::uint8_t> const& rgba, std::uint32_t x, std::uint32_t y, int c, bool srgb) {
    double sum = 0;
    for (std::uint32_t v = 0; v < from.height; ++v) {
        for (std::uint32_t u = 0; u < from.width; ++u) {
            double const weight = share(u, x, from.width) * share(v, y, from.height);
            if (weight > 0) sum += weight * light(rgba[(std::size_t{v} * from.width + u) * 4 + static_cast<std::size_t>(c)], srgb);
        }
    }
    return sum;
}

} // namespace

TEST(Mipmaps, are_means_over_areas_in_linear_light) {
    for (Extent const extent : {Extent{16, 16}, {16, 8}, {7, 5}, {9, 1}, {1, 6}, {12, 15}}) {
        std::vector<std::uint8_t> const rgba = texels(extent);
        for (bool const srgb : {false, true}) {
            ByteImage const first = mip_levels(extent, rgba, srgb).front();
            for (std::uint32_t y = 0; y < first.extent.height; ++y) {
                for (std::uint32_t x = 0; x < first.extent.width; ++x) {
                    for (int c = 0; c < 4; ++c) {
                        bool const curved = srgb && c < 3;
                        double const wanted = encoded(mean_over_area(extent, rgba, x, y, c, curved), curved);
                        // Rounding to a byte, and a tenth of one from the steps of the tables.
                        EXPECT_NEAR(first.at(x, y)[c], wanted, 0.6) << extent.width << "x" << extent.height << " at " << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(Mipmaps, go_down_to_one_texel) {
    auto const extents = [](Extent extent) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
        for (ByteImage const& level : mip_levels(extent, texels(extent), true)) result.emplace_back(level.extent.width, level.extent.height);
        return result;
    };
    EXPECT_TRUE(extents({1, 1}).empty());
    EXPECT_EQ(extents({5, 2}), (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{2, 1}, {1, 1}}));
    EXPECT_EQ(extents({1, 8}).size(), 3u);
    EXPECT_EQ(extents({2048, 4}).size(), 11u);
}

TEST(Mipmaps, of_one_colour_are_that_colour) {
    for (int value = 0; value < 256; ++value) {
        std::vector<std::uint8_t> const rgba(64 * 64 * 4, static_cast<std::uint8_t>(value));
        for (bool const srgb : {false, true}) {
            for (ByteImage const& level : mip_levels({64, 64}, rgba, srgb)) {
                for (std::uint8_t const byte : level.rgba) ASSERT_EQ(byte, value) << srgb;
            }
        }
    }
}
