#include "image/exr.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h>

using namespace alpenglow;

namespace {

FloatImage steps(Extent extent, float alpha) {
    FloatImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = i % 4 == 3 ? alpha : std::ldexp(1.0f + static_cast<float>(i % 97) / 97, static_cast<int>(i % 200) - 100);
    }
    return image;
}

std::filesystem::path scratch(char const* name) {
    return std::filesystem::path(testing::TempDir()) / (std::to_string(::getpid()) + name);
}

std::string message_of(std::span<std::byte const> bytes) {
    try {
        decode_exr(bytes);
    } catch (Error const& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return "";
}

/// A half-float file of the given channels with a data window that does not begin at the origin.
std::filesystem::path half_file(Imf::RgbaChannels channels, char const* name) {
    std::filesystem::path const path = scratch(name);
    Imath::Box2i const display({0, 0}, {9, 9}), data({-2, 3}, {1, 4});
    Imf::Array2D<Imf::Rgba> pixels(2, 4);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) pixels[y][x] = Imf::Rgba(0.5f, static_cast<float>(x), static_cast<float>(y), 0.25f);
    }
    Imf::RgbaOutputFile file(path.c_str(), display, data, channels);
    file.setFrameBuffer(&pixels[0][0] + 2 - 3 * 4, 1, 4);
    file.writePixels(2);
    return path;
}

} // namespace

TEST(Exr, floats_come_back_to_the_bit) {
    for (float alpha : {1.0f, 0.3f}) {
        FloatImage image = steps({53, 37}, alpha);
        image.at(1, 1)[0] = std::numeric_limits<float>::infinity();
        image.at(2, 1)[1] = -0.0f;
        FloatImage const back = decode_exr(encode_exr(image));
        EXPECT_EQ(back.extent, image.extent);
        EXPECT_EQ(back.rgba, image.rgba);
    }
}

TEST(Exr, alpha_is_kept_only_where_it_says_something) {
    EXPECT_LT(encode_exr(steps({64, 64}, 1.0f)).size(), encode_exr(steps({64, 64}, 0.5f)).size());
}

TEST(Exr, a_file_is_written_whole_or_not_at_all) {
    std::filesystem::path const path = scratch("whole.exr");
    write_exr(path, steps({8, 8}, 1));
    EXPECT_EQ(read_exr(path).rgba, steps({8, 8}, 1).rgba);
    std::filesystem::remove(path);
    EXPECT_THROW(write_exr("/dev/full/x.exr", steps({8, 8}, 1)), Error);
    EXPECT_THROW(encode_exr(FloatImage({0, 4})), Error);
}

TEST(Exr, half_floats_and_a_displaced_data_window_are_read) {
    std::filesystem::path const path = half_file(Imf::WRITE_RGBA, "half.exr");
    FloatImage const image = read_exr(path);
    std::filesystem::remove(path);
    ASSERT_EQ(image.extent, (Extent{4, 2}));
    EXPECT_EQ(image.at(3, 1)[0], 0.5f);
    EXPECT_EQ(image.at(3, 1)[1], 3.0f);
    EXPECT_EQ(image.at(3, 1)[2], 1.0f);
    EXPECT_EQ(image.at(3, 1)[3], 0.25f);
}

TEST(Exr, missing_channels_are_named) {
    std::filesystem::path const path = half_file(Imf::WRITE_Y, "grey.exr");
    try {
        read_exr(path);
        ADD_FAILURE() << "a file without R, G and B was read";
    } catch (Error const& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("no channel R"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
    std::filesystem::remove(path);
}

TEST(Exr, a_file_cut_short_anywhere_is_refused) {
    auto const bytes = encode_exr(steps({40, 40}, 1));
    for (std::size_t length = 0; length < bytes.size(); length += std::max<std::size_t>(1, length / 8)) {
        EXPECT_NE(message_of(std::span(bytes).first(length)), "") << length << " of " << bytes.size() << " bytes";
    }
}

TEST(Exr, garbage_is_refused) {
    EXPECT_NE(message_of(std::vector<std::byte>(4096, std::byte{'x'})), "");
    EXPECT_NE(message_of({}), "");
}

TEST(Exr, a_picture_bomb_is_refused_by_its_header) {
    auto bytes = encode_exr(steps({8, 8}, 1));
    // The data window's type name is followed by its size and by xMin, yMin, xMax, yMax, 32 bits each.
    std::string const key = std::string("dataWindow\0box2i\0\x10\0\0\0", 21);
    auto const* const text = reinterpret_cast<char const*>(bytes.data());
    auto const* const found = std::search(text, text + bytes.size(), key.begin(), key.end());
    ASSERT_NE(found, text + bytes.size());
    std::size_t const x_max = static_cast<std::size_t>(found - text) + key.size() + 8;
    for (std::size_t side : {x_max, x_max + 4}) bytes[side + 1] = std::byte{0x7f}; // 32519 along both sides
    EXPECT_NE(message_of(bytes), "");
}

TEST(ExrRecord, everything_comes_back) {
    RadianceRecord const record{steps({53, 37}, 1), steps({53, 37}, 1),
                                {{"command", "alpenglow reference a.json"}, {"seed", "7"}, {"note", ""}}};
    RadianceRecord const back = decode_record(encode_exr(record));
    EXPECT_EQ(back.radiance.rgba, record.radiance.rgba);
    ASSERT_TRUE(back.variance);
    EXPECT_EQ(back.variance->rgba, record.variance->rgba);
    EXPECT_EQ(back.attributes, record.attributes);
}

TEST(ExrRecord, radiance_and_variance_are_not_mixed_up) {
    RadianceRecord record{steps({8, 8}, 1), FloatImage({8, 8}), {}};
    record.variance->at(3, 2)[1] = 0.25f;
    std::filesystem::path const path = scratch("record.exr");
    write_exr(path, record);
    EXPECT_EQ(read_record(path).variance->at(3, 2)[1], 0.25f);
    EXPECT_EQ(read_exr(path).rgba, record.radiance.rgba) << "a reader of pictures sees the radiance alone";
    std::filesystem::remove(path);
}

TEST(ExrRecord, alpha_is_not_kept_and_variance_may_be_missing) {
    RadianceRecord const back = decode_record(encode_exr(RadianceRecord{steps({8, 8}, 0), {}, {}}));
    EXPECT_EQ(back.radiance.rgba, steps({8, 8}, 1).rgba);
    EXPECT_FALSE(back.variance);
    EXPECT_TRUE(back.attributes.empty());
    EXPECT_FALSE(decode_record(encode_exr(steps({8, 8}, 1))).variance);
}

TEST(ExrRecord, what_can_not_be_encoded_is_refused) {
    EXPECT_THROW(encode_exr(RadianceRecord{FloatImage(), {}, {}}), Error);
    EXPECT_THROW(encode_exr(RadianceRecord{FloatImage({8, 8}), FloatImage({8, 9}), {}}), Error);
    for (std::string const& name : {std::string(), std::string(256, 'a'), std::string(3, '\0'), std::string("dataWindow")}) {
        EXPECT_THROW(encode_exr(RadianceRecord{FloatImage({8, 8}), {}, {{name, "text"}}}), Error) << name;
    }
}

TEST(ExrRecord, a_text_that_claims_more_than_the_file_has_is_refused) {
    auto const whole = encode_exr(RadianceRecord{steps({8, 8}, 1), {}, {{"seed", "12345678"}}});
    std::string const key = std::string("seed\0string\0", 12);
    auto const* const text = reinterpret_cast<char const*>(whole.data());
    auto const* const found = std::search(text, text + whole.size(), key.begin(), key.end());
    ASSERT_NE(found, text + whole.size());
    std::size_t const size = static_cast<std::size_t>(found - text) + key.size(); // 32 bits, little endian
    for (auto const& claim : {std::array{0xff, 0xff, 0xff, 0xff}, {0xff, 0xff, 0xff, 0x7f}, {0, 0, 1, 0}}) {
        auto bytes = whole;
        for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = static_cast<std::byte>(claim[i]);
        EXPECT_NE(message_of(bytes).find("cut short"), std::string::npos) << message_of(bytes);
    }
}

TEST(ExrRecord, a_lost_channel_of_the_variance_is_named) {
    auto bytes = encode_exr(RadianceRecord{steps({8, 8}, 1), steps({8, 8}, 1), {}});
    std::string const name = "variance.G";
    auto* const text = reinterpret_cast<char*>(bytes.data());
    auto* const found = std::search(text, text + bytes.size(), name.begin(), name.end());
    ASSERT_NE(found, text + bytes.size());
    found[name.size() - 1] = 'H';
    try {
        decode_record(bytes);
        ADD_FAILURE() << "a record without variance.G was read";
    } catch (Error const& error) {
        EXPECT_NE(std::string(error.what()).find("no channel variance.G"), std::string::npos) << error.what();
    }
    EXPECT_EQ(decode_exr(bytes).rgba, steps({8, 8}, 1).rgba);
}
