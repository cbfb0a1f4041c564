#include "image/mask.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace alpenglow;

namespace {

FloatImage grey(std::vector<float> const& values) {
    FloatImage image({static_cast<std::uint32_t>(values.size()), 1});
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) image.rgba[4 * i + c] = values[i];
    return image;
}

} // namespace

TEST(Mask, holds_what_differs_by_more_than_the_share) {
    std::vector<bool> const mask = where_apart(grey({1, 1.01f, 1.03f, 0.97f, 0, 5}), grey({1, 1, 1, 1, 0, 4.95f}), 0.02);
    EXPECT_EQ(mask, (std::vector<bool>{false, false, true, true, false, false}));
    EXPECT_DOUBLE_EQ(share_of(mask), 1.0 / 3);
    EXPECT_EQ(share_of({}), 0);
}

TEST(Mask, weighs_channels_by_luminance) {
    FloatImage const reference = grey({1, 1});
    FloatImage test = reference;
    test.at(0, 0)[1] = 1.03f; // 0.7152 of it is 2.1 %
    test.at(1, 0)[2] = 1.25f; // 0.0722 of it is 1.8 %
    EXPECT_EQ(where_apart(test, reference, 0.02), (std::vector<bool>{true, false}));
}

TEST(Mask, holds_what_is_not_finite) {
    FloatImage test = grey({1, 1, 1}), reference = test;
    test.at(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    reference.at(1, 0)[2] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(where_apart(test, reference, 0.02), (std::vector<bool>{true, true, false}));
}

TEST(Mask, mean_is_over_what_it_holds) {
    std::vector<float> const values{1, 10, 100, 1000};
    EXPECT_DOUBLE_EQ(*masked_mean(values, {true, false, true, false}), 50.5);
    EXPECT_DOUBLE_EQ(*masked_mean(values, {true, true, true, true}), 1111.0 / 4);
    EXPECT_FALSE(masked_mean(values, {false, false, false, false}));
}

TEST(Mask, refuses_pictures_of_different_sizes) { EXPECT_THROW(where_apart(grey({1}), grey({1, 1}), 0.02), Error); }
