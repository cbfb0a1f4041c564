#include "image/metrics.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace alpenglow;

namespace {

FloatImage uniform(Extent extent, float red, float green, float blue) {
    FloatImage image(extent);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        image.rgba[i] = red, image.rgba[i + 1] = green, image.rgba[i + 2] = blue, image.rgba[i + 3] = 1;
    }
    return image;
}

} // namespace

/// Values are powers of two, so that the closed forms hold to a few roundings of double.
TEST(Metrics, errors_of_uniform_pictures_are_closed_forms) {
    Metrics const m = measure(uniform({7, 5}, 1.25f, 2, 3.5f), uniform({7, 5}, 1, 2, 4));
    double const mse = (0.0625 + 0 + 0.25) / 3;
    EXPECT_DOUBLE_EQ(*m.mse, mse);
    EXPECT_DOUBLE_EQ(*m.rmse, std::sqrt(mse));
    EXPECT_DOUBLE_EQ(*m.rel_rmse, std::sqrt(mse) / (7.0 / 3));
    EXPECT_DOUBLE_EQ(*m.psnr, 10 * std::log10(16 / mse));
    EXPECT_DOUBLE_EQ(*m.bias[0], 0.25);
    EXPECT_DOUBLE_EQ(*m.bias[1], 0);
    EXPECT_DOUBLE_EQ(*m.bias[2], -0.125);
    EXPECT_DOUBLE_EQ(*m.p999, 0.5);
    EXPECT_EQ(m.non_finite, 0);
}

TEST(Metrics, a_peak_that_is_told_is_the_peak) {
    Metrics const m = measure(uniform({4, 4}, 0.5f, 0.5f, 0.5f), uniform({4, 4}, 0.25f, 0.25f, 0.25f), 1.0);
    EXPECT_DOUBLE_EQ(*m.psnr, 10 * std::log10(1 / 0.0625));
}

TEST(Metrics, bias_cancels_what_rmse_sums) {
    FloatImage test = uniform({2, 1}, 1, 1, 1);
    test.at(0, 0)[1] = 1.5f;
    test.at(1, 0)[1] = 0.5f;
    Metrics const m = measure(test, uniform({2, 1}, 1, 1, 1));
    EXPECT_DOUBLE_EQ(*m.bias[1], 0);
    EXPECT_DOUBLE_EQ(*m.mse, 0.25 / 3);
}

TEST(Metrics, p999_leaves_out_one_value_in_a_thousand) {
    FloatImage const reference = uniform({100, 10}, 0, 0, 0);
    FloatImage test = reference;
    int error = 0;
    for (std::size_t i = 0; i < test.rgba.size(); ++i) {
        if (i % 4 != 3) test.rgba[i] = static_cast<float>(error++ % 2 ? error : -error);
    }
    EXPECT_EQ(*measure(test, reference).p999, 2997); // of the errors 1 to 3000
}

TEST(Metrics, equal_pictures_have_no_error_and_no_noise) {
    Metrics const m = measure(uniform({4, 4}, 1, 2, 3), uniform({4, 4}, 1, 2, 3));
    EXPECT_EQ(*m.mse, 0);
    EXPECT_EQ(*m.p999, 0);
    EXPECT_TRUE(std::isinf(*m.psnr));
}

TEST(Metrics, what_a_black_reference_leaves_undefined_is_empty) {
    Metrics const m = measure(uniform({4, 4}, 1, 1, 1), uniform({4, 4}, 0, 0, 0));
    EXPECT_EQ(*m.mse, 1);
    EXPECT_FALSE(m.rel_rmse);
    EXPECT_FALSE(m.psnr);
    for (auto const& bias : m.bias) EXPECT_FALSE(bias);
    EXPECT_FALSE(measure(uniform({4, 4}, 1, 1, 1), uniform({4, 4}, 1, 0, 1)).bias[1]);
}

TEST(Metrics, pixels_that_are_not_finite_are_counted_and_left_out) {
    FloatImage test = uniform({4, 4}, 1, 1, 1), reference = uniform({4, 4}, 2, 2, 2);
    test.at(1, 1)[2] = std::nanf("");
    reference.at(2, 2)[0] = std::numeric_limits<float>::infinity();
    test.at(3, 3)[0] = reference.at(3, 3)[1] = std::nanf("");
    test.at(0, 0)[3] = std::nanf(""); // alpha is no colour
    Metrics const m = measure(test, reference);
    EXPECT_EQ(m.non_finite, 3.0 / 16);
    EXPECT_EQ(*m.mse, 1);
    EXPECT_EQ(*m.bias[0], -0.5);
}

TEST(Metrics, of_pictures_without_a_finite_pixel_only_the_share_is_known) {
    float const nan = std::nanf("");
    Metrics const m = measure(uniform({4, 4}, nan, nan, nan), uniform({4, 4}, 1, 1, 1));
    EXPECT_EQ(m.non_finite, 1);
    EXPECT_FALSE(m.mse || m.rmse || m.rel_rmse || m.psnr || m.bias[0] || m.p999);
}

TEST(Metrics, pictures_of_different_extents_are_refused) {
    EXPECT_THROW(measure(FloatImage({8, 8}), FloatImage({8, 9})), Error);
    EXPECT_THROW(measure(FloatImage(), FloatImage()), Error);
}
