#include "image/codec.h"
#include "image/color.h"
#include "image/exr.h"
#include "image/flip.h"
#include "image/metrics.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

using namespace alpenglow;

namespace {

std::filesystem::path shared_folder() {
    char const* const given = std::getenv("ALPENGLOW_SHARED");
    return given ? std::filesystem::path(given) : std::filesystem::path(ALPENGLOW_SOURCE) / "../shared";
}

ByteImage uniform(Extent extent, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    ByteImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        image.rgba[i] = red, image.rgba[i + 1] = green, image.rgba[i + 2] = blue, image.rgba[i + 3] = 255;
    }
    return image;
}

struct Pair {
    char const* name;
    double mean, median, largest; ///< of the authors' own implementation, default parameters
    double mse;                   ///< printed beside it, in linear RGB
    ExposureRange exposures{};    ///< of an HDR pair
};

class FlipPairs : public testing::TestWithParam<Pair> {
protected:
    bool is_hdr() const { return GetParam().exposures.count > 1; }

    std::filesystem::path file(std::string const& which) const {
        return shared_folder() / "flip" / (GetParam().name + ("_" + which) + (is_hdr() ? ".exr" : ".png"));
    }

    FloatImage load(std::string const& which) const {
        return is_hdr() ? read_exr(file(which)) : linear_from_srgb(read_picture(file(which)));
    }
};

} // namespace

TEST_P(FlipPairs, meet_the_authors_implementation) {
    if (!std::filesystem::exists(file("test"))) {
        if (std::getenv("CI")) FAIL() << "there is no " << file("test");
        GTEST_SKIP() << "there is no " << file("test");
    }
    FloatImage const reference = load("reference"), test = load("test");
    HdrFlipResult const flip =
        is_hdr() ? compute_hdr_flip(reference, test) : HdrFlipResult{compute_flip(reference, test), {}};
    // The authors compute in float and with rounded constants.
    EXPECT_NEAR(flip.mean, GetParam().mean, 5e-4);
    EXPECT_NEAR(flip.median, GetParam().median, 5e-4);
    EXPECT_NEAR(flip.largest, GetParam().largest, 5e-3);
    EXPECT_NEAR(*measure(test, reference).mse / GetParam().mse, 1, 1e-5); // seven digits, of sums in float
    // Printed there with five decimals.
    EXPECT_NEAR(flip.exposures.start, GetParam().exposures.start, 2e-5);
    EXPECT_NEAR(flip.exposures.stop, GetParam().exposures.stop, 2e-5);
    EXPECT_EQ(flip.exposures.count, GetParam().exposures.count);
}

INSTANTIATE_TEST_SUITE_P(Ldr, FlipPairs,
                         testing::Values(Pair{"1_gradient", 0.064727, 0.063955, 0.105828, 1.255168e-04},
                                         Pair{"2_shift", 0.043051, 0.022042, 0.624709, 1.455059e-03},
                                         Pair{"3_blur", 0.032525, 0.008512, 0.291055, 1.000532e-03}),
                         [](auto const& pair) { return std::string(pair.param.name); });
INSTANTIATE_TEST_SUITE_P(Hdr, FlipPairs,
                         testing::Values(Pair{"4_tint", 0.070772, 0.071672, 0.101443, 1.869190e-05,
                                              {-0.86727, 7.92558, 9}},
                                         Pair{"5_shafts", 0.177350, 0.109962, 0.835391, 7.063090e-06,
                                              {-0.86727, 7.24524, 9}},
                                         Pair{"6_fireflies", 0.021030, 0, 0.951079, 6.510417e-03,
                                              {-0.86727, 7.92558, 9}}),
                         [](auto const& pair) { return std::string(pair.param.name); });

namespace {

FloatImage hills(float brightness) {
    FloatImage image({40, 30});
    for (std::uint32_t y = 0; y < 30; ++y) {
        for (std::uint32_t x = 0; x < 40; ++x) {
            float const value = brightness * std::exp2(static_cast<float>((x * 7 + y * 3) % 11) - 5);
            float* const p = image.at(x, y);
            p[0] = value, p[1] = 0.8f * value, p[2] = 0.5f * value, p[3] = 1;
        }
    }
    return image;
}

} // namespace

TEST(HdrFlip, does_not_depend_on_the_unit) {
    FloatImage test = hills(1);
    for (std::size_t i = 0; i < test.rgba.size(); i += 8) test.rgba[i] *= 1.1f;
    FloatImage brighter = test;
    for (float& value : brighter.rgba) value *= 1024;
    HdrFlipResult const flip = compute_hdr_flip(hills(1), test), scaled = compute_hdr_flip(hills(1024), brighter);
    EXPECT_GT(flip.mean, 0.01);
    EXPECT_NEAR(scaled.mean, flip.mean, 1e-5); // roundings of the exposures
    EXPECT_EQ(compute_hdr_flip(hills(1), hills(1)).largest, 0);
}

TEST(HdrFlip, sees_what_one_exposure_hides) {
    FloatImage test = hills(1000); // 1 - exp(-30) and more: all white where LDR FLIP looks
    for (float& value : test.rgba) value *= 0.9f;
    auto const bright = [](FloatImage const& image) { return exponential_display(image, 0); };
    EXPECT_LT(compute_flip(bright(hills(1000)), bright(test)).mean, 1e-4);
    EXPECT_GT(compute_hdr_flip(hills(1000), test).mean, 0.02);
}

/// Never a silent zero: the same pixel broken in both pictures is no agreement.
TEST(HdrFlip, pixels_that_are_not_finite_have_the_error_1_and_touch_no_other) {
    FloatImage const whole = hills(1);
    for (float const broken : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
        FloatImage image = whole;
        image.at(20, 15)[1] = broken;
        for (FlipResult const& flip : {FlipResult(compute_hdr_flip(image, image)), compute_flip(image, image)}) {
            EXPECT_EQ(flip.largest, 1);
            EXPECT_EQ(flip.error[15 * 40 + 20], 1);
            EXPECT_NEAR(flip.mean, 1.0 / (40 * 30), 1e-9);
        }
        EXPECT_EQ(compute_hdr_flip(whole, image).error[15 * 40 + 20], 1);
    }
}

TEST(HdrFlip, pictures_of_different_extents_are_refused) {
    EXPECT_THROW(compute_hdr_flip(FloatImage({8, 8}), FloatImage({8, 9})), Error);
    EXPECT_THROW(compute_hdr_flip(FloatImage(), FloatImage()), Error);
}

TEST(ExponentialDisplay, is_the_curve_and_hides_nothing) {
    FloatImage radiance({2, 1});
    radiance.rgba = {0, 1, 2, 0.5f, std::numeric_limits<float>::infinity(), std::nanf(""), -1, 1};
    FloatImage const shown = exponential_display(radiance, 1);
    EXPECT_EQ(shown.rgba[0], 0);
    EXPECT_FLOAT_EQ(shown.rgba[1], 1 - std::exp(-2.0f));
    EXPECT_FLOAT_EQ(shown.rgba[2], 1 - std::exp(-4.0f));
    EXPECT_EQ(shown.rgba[3], 0.5f);
    EXPECT_TRUE(std::isinf(shown.rgba[4]));
    EXPECT_TRUE(std::isnan(shown.rgba[5]));
}

TEST(Flip, is_nothing_for_equal_pictures_and_one_for_the_farthest_colours) {
    ByteImage const green = uniform({8, 8}, 0, 255, 0), blue = uniform({8, 8}, 0, 0, 255);
    EXPECT_EQ(compute_flip(green, green).largest, 0);
    // Green to blue is the distance that the paper scales to 1.
    EXPECT_NEAR(compute_flip(green, blue).mean, 1, 1e-6);
}

TEST(Flip, pictures_of_different_extents_are_refused) {
    EXPECT_THROW(compute_flip(ByteImage({8, 8}), ByteImage({8, 9})), Error);
    EXPECT_THROW(compute_flip(ByteImage(), ByteImage()), Error);
}
