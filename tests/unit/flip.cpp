#include "image/codec.h"
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
};

class FlipPairs : public testing::TestWithParam<Pair> {};

} // namespace

TEST_P(FlipPairs, meet_the_authors_implementation) {
    std::filesystem::path const folder = shared_folder() / "flip";
    std::string const name = GetParam().name;
    if (!std::filesystem::exists(folder / (name + "_test.png"))) {
        if (std::getenv("CI")) FAIL() << "the pictures are not in " << folder;
        GTEST_SKIP() << "the pictures are not in " << folder;
    }
    FlipResult const flip = compute_flip(read_picture(folder / (name + "_reference.png")), read_picture(folder / (name + "_test.png")));
    // The authors compute in float and with rounded constants.
    EXPECT_NEAR(flip.mean, GetParam().mean, 5e-4);
    EXPECT_NEAR(flip.median, GetParam().median, 5e-4);
    EXPECT_NEAR(flip.largest, GetParam().largest, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Ldr, FlipPairs,
                         testing::Values(Pair{"1_gradient", 0.064727, 0.063955, 0.105828}, Pair{"2_shift", 0.043051, 0.022042, 0.624709},
                                         Pair{"3_blur", 0.032525, 0.008512, 0.291055}),
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
