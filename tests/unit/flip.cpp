#include "image/codec.h"
#include "image/exr.h"
#include "image/flip.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
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
    ExposureRange exposures{};    ///< of an HDR pair
};

class FlipPairs : public testing::TestWithParam<Pair> {
protected:
    bool is_hdr() const { return GetParam().exposures.count > 1; }

    std::filesystem::path file(std::string const& which) const {
        return shared_folder() / "flip" / (GetParam().name + ("_" + which) + (is_hdr() ? ".exr" : ".png"));
    }

    HdrFlipResult compute() const {
        if (is_hdr()) return compute_hdr_flip(read_exr(file("reference")), read_exr(file("test")));
        return {compute_flip(read_picture(file("reference")), read_picture(file("test"))), {}};
    }
};

} // namespace

TEST_P(FlipPairs, meet_the_authors_implementation) {
    if (!std::filesystem::exists(file("test"))) {
        if (std::getenv("CI")) FAIL() << "there is no " << file("test");
        GTEST_SKIP() << "there is no " << file("test");
    }
    HdrFlipResult const flip = compute();
    // The authors compute in float and with rounded constants.
    EXPECT_NEAR(flip.mean, GetParam().mean, 5e-4);
    EXPECT_NEAR(flip.median, GetParam().median, 5e-4);
    EXPECT_NEAR(flip.largest, GetParam().largest, 5e-3);
    // Printed there with five decimals.
    EXPECT_NEAR(flip.exposures.start, GetParam().exposures.start, 2e-5);
    EXPECT_NEAR(flip.exposures.stop, GetParam().exposures.stop, 2e-5);
    EXPECT_EQ(flip.exposures.count, GetParam().exposures.count);
}

INSTANTIATE_TEST_SUITE_P(Ldr, FlipPairs,
                         testing::Values(Pair{"1_gradient", 0.064727, 0.063955, 0.105828},
                                         Pair{"2_shift", 0.043051, 0.022042, 0.624709},
                                         Pair{"3_blur", 0.032525, 0.008512, 0.291055}),
                         [](auto const& pair) { return std::string(pair.param.name); });
INSTANTIATE_TEST_SUITE_P(Hdr, FlipPairs,
                         testing::Values(Pair{"4_tint", 0.070772, 0.071672, 0.101443, {-0.86727, 7.92558, 9}},
                                         Pair{"5_shafts", 0.177350, 0.109962, 0.835391, {-0.86727, 7.24524, 9}},
                                         Pair{"6_fireflies", 0.021030, 0, 0.951079, {-0.86727, 7.92558, 9}}),
                         [](auto const& pair) { return std::string(pair.param.name); });

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
