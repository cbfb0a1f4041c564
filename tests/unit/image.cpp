#include "image/codec.h"
#include "image/color.h"
#include "image/compare.h"
#include "image/resample.h"

#include "core/error.h"
#include "support/deep_png.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

using namespace alpenglow;

namespace {

ByteImage noise(Extent extent, std::uint8_t alpha) {
    ByteImage image(extent);
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        state = state * 1664525u + 1013904223u;
        image.rgba[i] = i % 4 == 3 ? alpha : static_cast<std::uint8_t>(state >> 24);
    }
    return image;
}

ByteImage uniform(Extent extent, std::uint8_t value) {
    ByteImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : value;
    return image;
}

} // namespace

TEST(Png, comes_back_to_the_bit) {
    for (int alpha : {255, 77}) {
        ByteImage const image = noise({67, 31}, static_cast<std::uint8_t>(alpha));
        auto const bytes = encode_png(image);
        EXPECT_EQ(decode_picture(bytes).rgba, image.rgba);
        EXPECT_EQ(read_picture_header(bytes).extent, image.extent);
        EXPECT_EQ(read_picture_header(bytes).channels, alpha == 255 ? 3 : 4);
    }
}

TEST(Png, sixteen_bits_come_back_to_the_bit) {
    DeepImage image = test::deep_gradient({300, 2}, 12345, 1);
    image.at(7, 1)[3] = 54321;
    auto const bytes = test::deep_png(image);
    EXPECT_EQ(read_picture_header(bytes).bits, 16);
    EXPECT_EQ(read_picture_header(encode_png(noise({4, 4}, 255))).bits, 8);
    DeepImage const decoded = decode_deep_picture(bytes);
    EXPECT_EQ(decoded.extent, image.extent);
    EXPECT_EQ(decoded.rgba, image.rgba);
}

TEST(Png, compresses_a_smooth_picture) {
    ByteImage image = uniform({256, 256}, 0);
    for (std::uint32_t y = 0; y < 256; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) image.at(x, y)[2] = static_cast<std::uint8_t>(y);
    }
    EXPECT_LT(encode_png(image).size(), image.rgba.size() / 50);
}

TEST(Png, garbage_and_truncated_files_are_refused) {
    auto bytes = encode_png(noise({16, 16}, 255));
    bytes.resize(bytes.size() / 2);
    EXPECT_THROW(decode_picture(bytes), Error);
    EXPECT_THROW(decode_picture({}), Error);
    auto deep = test::deep_png(test::deep_gradient({16, 16}, 0, 1));
    deep.resize(deep.size() / 2);
    EXPECT_THROW(decode_deep_picture(deep), Error);
    EXPECT_THROW(read_picture_header(std::vector<std::byte>(4096, std::byte{'x'})), Error);
}

TEST(Color, srgb_meets_the_standards_own_values) {
    // IEC 61966-2-1: the ends, the join of its two pieces, and 18 % grey, which is 118 of 255.
    EXPECT_EQ(srgb_from_linear(0.0f), 0.0f);
    EXPECT_NEAR(srgb_from_linear(1.0f), 1.0f, 1e-6);
    EXPECT_NEAR(srgb_from_linear(0.0031308f), 0.04045f, 1e-5);
    EXPECT_EQ(srgb_byte_from_linear(0.18f), 118);
    EXPECT_NEAR(luminance(1, 1, 1), 1, 1e-6);
}

TEST(Color, every_byte_survives_the_way_there_and_back) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(srgb_byte_from_linear(linear_from_srgb_byte(static_cast<std::uint8_t>(i))), i);
    }
}

TEST(Color, bytes_are_clamped) {
    EXPECT_EQ(srgb_byte_from_linear(7.0f), 255);
    EXPECT_EQ(srgb_byte_from_linear(-1.0f), 0);
    EXPECT_EQ(srgb_byte_from_linear(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(srgb_byte_from_linear(std::nanf("")), 0);
}

TEST(Compare, finds_the_largest_difference_and_its_share) {
    ByteImage const a = uniform({10, 10}, 100);
    ByteImage b = a;
    b.at(3, 4)[1] = 140;
    b.at(5, 6)[0] = 98;
    b.at(5, 7)[3] = 0; // alpha does not count
    ByteDifference const d = compare(a, b, 2);
    EXPECT_EQ(d.largest, 40);
    EXPECT_EQ(d.x, 3u);
    EXPECT_EQ(d.y, 4u);
    EXPECT_DOUBLE_EQ(d.mean, 42.0 / 300);
    EXPECT_DOUBLE_EQ(d.share_above, 0.01);
    EXPECT_DOUBLE_EQ(compare(a, b, 1).share_above, 0.02);
    EXPECT_EQ(compare(a, a, 0).largest, 0);
    EXPECT_EQ(difference_picture(a, b, 2).at(3, 4)[1], 80);
    EXPECT_EQ(difference_picture(a, b, 100).at(3, 4)[1], 255);
    EXPECT_EQ(side_by_side(a, b).extent, (Extent{38, 10}));
}

TEST(Compare, pictures_of_different_extents_are_refused) {
    EXPECT_THROW(compare(ByteImage({2, 3}), ByteImage({3, 2}), 0), Error);
    EXPECT_THROW(compare(FloatImage({2, 3}), FloatImage({3, 2})), Error);
    EXPECT_THROW(difference_picture(ByteImage({2, 3}), ByteImage({3, 2})), Error);
}

TEST(Compare, radiance_by_mean_and_rmse) {
    FloatImage a({2, 1}), b({2, 1});
    b.at(0, 0)[0] = 3;
    b.at(1, 0)[2] = -4;
    b.at(1, 0)[3] = 100; // alpha does not count
    FloatDifference const d = compare(a, b);
    EXPECT_DOUBLE_EQ(d.largest, 4);
    EXPECT_DOUBLE_EQ(d.mean, 7.0 / 6);
    EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(25.0 / 6));
    EXPECT_DOUBLE_EQ(compare(b, a).mean_a, -1.0 / 6);
}

TEST(Compare, what_is_not_finite_never_passes) {
    FloatImage a({2, 1}), b({2, 1});
    a.at(1, 0)[1] = std::nanf("");
    EXPECT_EQ(compare(a, b).largest, std::numeric_limits<double>::infinity());
    EXPECT_EQ(compare(a, a).rmse, std::numeric_limits<double>::infinity());
    EXPECT_EQ(count_non_finite(a), 1u);
    EXPECT_EQ(count_non_finite(b), 0u);
}

TEST(Resample, averages_in_linear_light) {
    ByteImage checks({2, 2});
    for (std::uint32_t i = 0; i < 4; ++i) {
        std::uint8_t const value = (i == 0 || i == 3) ? 255 : 0;
        for (int c = 0; c < 3; ++c) checks.rgba[i * 4 + c] = value;
        checks.rgba[i * 4 + 3] = 255;
    }
    // Half of the light is 188 in sRGB, not 128.
    EXPECT_EQ(resample(checks, {1, 1}).at(0, 0)[0], 188);
    EXPECT_EQ(resample(checks, {1, 1}).at(0, 0)[3], 255);
}

TEST(Resample, keeps_a_uniform_picture_at_any_ratio) {
    for (Extent extent : {Extent{7, 5}, Extent{33, 64}, Extent{200, 1}}) {
        ByteImage const small = resample(uniform({100, 75}, 91), extent);
        EXPECT_EQ(small.extent, extent);
        EXPECT_EQ(compare(small, uniform(extent, 91), 0).largest, 0);
    }
    EXPECT_THROW(resample(uniform({4, 4}, 1), {0, 4}), Error);
}

TEST(Codec, jpeg_tables_of_too_many_codes_are_refused) {
    // Start, then a segment of one table: 16 counts of 17 codes. In a segment of any length that holds the table's first byte.
    for (int const length : {0x123, 0x08}) {
        std::vector<std::byte> bytes(7 + 16 + 272);
        int at = 0;
        for (int const value : {0xFF, 0xD8, 0xFF, 0xC4, length >> 8, length & 255, 0}) bytes[at++] = static_cast<std::byte>(value);
        for (int i = 0; i < 16; ++i) bytes[at++] = std::byte{17};
        test::expect_error(ErrorKind::bad_input, {"a table of 272 codes"}, [&] { read_picture_header(bytes); });
        test::expect_error(ErrorKind::bad_input, {"a table of 272 codes"}, [&] { decode_picture(bytes); });
    }
}

/// stb_image alone reads such a file too, but by way of a null pointer, which the sanitizers report.
TEST(Codec, png_with_empty_chunks_of_data_is_read) {
    ByteImage const image = noise({9, 5}, 255);
    std::vector<std::byte> bytes = encode_png(image);
    constexpr std::array<int, 12> empty{0, 0, 0, 0, 'I', 'D', 'A', 'T', 0x35, 0xAF, 0x06, 0x1E};
    std::vector<std::byte> chunk;
    for (int const value : empty) chunk.push_back(static_cast<std::byte>(value));
    constexpr std::ptrdiff_t behind_header = 33, end_chunk = 12;
    bytes.insert(bytes.end() - end_chunk, chunk.begin(), chunk.end());
    bytes.insert(bytes.begin() + behind_header, chunk.begin(), chunk.end());
    EXPECT_EQ(compare(decode_picture(bytes), image, 0).largest, 0);
    EXPECT_EQ(decode_deep_picture(bytes).rgba.front(), image.rgba.front() * 257);
    bytes.resize(bytes.size() - end_chunk - 3); // ends inside an empty chunk
    EXPECT_THROW(decode_picture(bytes), Error);
}
