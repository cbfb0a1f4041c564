#include "image/flip_color.h"
#include "image/flip_filters.h"
#include "image/flip_tone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace alpenglow;
using namespace alpenglow::flip;

namespace {

Plane plane(Extent extent, std::function<float(std::uint32_t, std::uint32_t)> const& f) {
    Plane result(extent);
    for (std::uint32_t y = 0; y < extent.height; ++y) {
        for (std::uint32_t x = 0; x < extent.width; ++x) result.values[std::size_t{y} * extent.width + x] = f(x, y);
    }
    return result;
}

float at(Plane const& p, std::uint32_t x, std::uint32_t y) { return p.values[std::size_t{y} * p.extent.width + x]; }

void expect_near(Color const& color, Color const& wanted, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(color[i], wanted[i], tolerance) << i;
}

FloatImage grey(std::vector<float> const& values) {
    FloatImage image({static_cast<std::uint32_t>(values.size()), 1});
    for (std::size_t i = 0; i < values.size(); ++i) std::fill_n(&image.rgba[i * 4], 3, values[i]);
    return image;
}

} // namespace

TEST(FlipColor, opponent_space_has_its_white_and_comes_back) {
    expect_near(ycxcz_from_rgb({1, 1, 1}), {100, 0, 0}, 1e-4);
    expect_near(ycxcz_from_rgb({0, 0, 0}), {-16, 0, 0}, 1e-4);
    for (Color const& color : {Color{1, 0, 0}, Color{0, 1, 0}, Color{0, 0, 1}, Color{0.2f, 0.5f, 0.05f}}) {
        expect_near(rgb_from_ycxcz(ycxcz_from_rgb(color)), color, 2e-6); // a few roundings of float
    }
}

/// CIELAB of Rec.709 red under D65, as widely printed: 53.24, 80.09, 67.20. Hunt: a and b times 0.01 L*.
TEST(FlipColor, hunt_takes_colourfulness_from_the_dark) {
    expect_near(hunt_lab_from_rgb({1, 0, 0}), {53.24f, 0.5324f * 80.09f, 0.5324f * 67.20f}, 0.02);
    expect_near(hunt_lab_from_rgb({1, 1, 1}), {100, 0, 0}, 1e-3);
    // 1/1000 of white is on the straight start of the curve, where L* = 903.3 Y.
    expect_near(hunt_lab_from_rgb({1e-3f, 1e-3f, 1e-3f}), {0.9033f, 0, 0}, 1e-4);
}

TEST(FlipColor, hyab_is_city_block_in_lightness_and_euclidean_in_colour) {
    EXPECT_FLOAT_EQ(hyab({1, 2, 3}, {3, 5, 7}), 2 + 5);
    EXPECT_FLOAT_EQ(hyab({3, 5, 7}, {1, 2, 3}), 2 + 5);
}

TEST(FlipColor, error_is_0_at_0_and_1_from_green_to_blue_with_a_knee) {
    float const largest = hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1}));
    EXPECT_EQ(color_error(0), 0);
    EXPECT_NEAR(color_error(largest), 1, 1e-6);
    // The power 0.7 brings 0.4^(1/0.7) of the largest distance to 0.4 of its compressed range: the knee, at 0.95.
    float const knee = largest * std::pow(0.4f, 1 / 0.7f);
    EXPECT_NEAR(color_error(knee), 0.95, 1e-5);
    EXPECT_NEAR(color_error(0.5f * knee), 0.95 * std::pow(0.5, 0.7), 1e-5);
}

TEST(FlipFilters, contrast_sensitivity_keeps_what_is_uniform) {
    Filters const filters(67);
    Plane const uniform = plane({30, 20}, [](auto, auto) { return 7.0f; });
    for (Sensitivity const& sensitivity : filters.sensitivity) {
        for (float const value : resolved(sensitivity, uniform).values) ASSERT_NEAR(value, 7, 1e-4);
    }
}

TEST(FlipFilters, contrast_sensitivity_has_the_gaussians_of_the_paper) {
    constexpr double pixels_per_degree = 67;
    Filters const filters(pixels_per_degree);
    Plane const dot = plane({41, 41}, [](auto x, auto y) { return x == 20 && y == 20 ? 1.0f : 0.0f; });
    // The sum of a sqrt(pi / b) exp(-pi² x² / b) over the lobes of Table 1, over its value in the centre.
    auto const fall = [&](std::initializer_list<std::pair<double, double>> lobes, double x) {
        double sum = 0, centre = 0;
        for (auto [a, b] : lobes) {
            double const peak = a * std::sqrt(M_PI / b);
            centre += peak;
            sum += peak * std::exp(-std::pow(M_PI * x / pixels_per_degree, 2) / b);
        }
        return sum / centre;
    };
    for (std::uint32_t const x : {1u, 3u}) {
        Plane const y = resolved(filters.sensitivity[0], dot), cx = resolved(filters.sensitivity[1], dot),
                    cz = resolved(filters.sensitivity[2], dot);
        EXPECT_NEAR(at(y, 20 + x, 20) / at(y, 20, 20), fall({{1, 0.0047}}, x), 1e-5);
        EXPECT_NEAR(at(cx, 20, 20 + x) / at(cx, 20, 20), fall({{1, 0.0053}}, x), 1e-5);
        EXPECT_NEAR(at(cz, 20 + x, 20) / at(cz, 20, 20), fall({{34.1, 0.04}, {13.5, 0.025}}, x), 1e-5);
        double const total = std::accumulate(cz.values.begin(), cz.values.end(), 0.0);
        EXPECT_NEAR(total, 1, 1e-5);
    }
}

TEST(FlipFilters, beyond_the_edges_the_last_pixel_is_repeated) {
    Plane const ramp = plane({5, 1}, [](auto x, auto) { return static_cast<float>(x); });
    Plane const shifted = convolve(ramp, {0, 0, 1}, {1}); // takes the right neighbour
    EXPECT_EQ(shifted.values, (std::vector<float>{1, 2, 3, 4, 4}));
    Plane const down = convolve(plane({1, 3}, [](auto, auto y) { return static_cast<float>(y); }), {1}, {1, 0, 0});
    EXPECT_EQ(down.values, (std::vector<float>{0, 0, 1}));
}

TEST(FlipFilters, a_full_step_is_an_edge_of_1_whichever_way_it_lies) {
    Filters const filters(67);
    Features const across = find_features(filters, plane({60, 40}, [](auto x, auto) { return x < 30 ? 0.0f : 1.0f; }));
    Features const down = find_features(filters, plane({40, 60}, [](auto, auto y) { return y < 30 ? 0.0f : 1.0f; }));
    EXPECT_NEAR(at(across.edges, 30, 20), 1, 1e-5);
    EXPECT_NEAR(at(down.edges, 20, 30), 1, 1e-5);
    EXPECT_NEAR(at(across.edges, 5, 20), 0, 1e-6) << "nothing far from it";
}

TEST(FlipFilters, a_line_is_a_point_feature_and_no_edge_at_its_middle) {
    Filters const filters(67);
    Features const line = find_features(filters, plane({61, 40}, [](auto x, auto) { return x == 30 ? 1.0f : 0.0f; }));
    EXPECT_NEAR(at(line.edges, 30, 20), 0, 1e-6);
    EXPECT_GT(at(line.points, 30, 20), 0.1f);
    // What only grows evenly has edges of one strength and, away from the borders, no points.
    Features const ramp =
        find_features(filters, plane({61, 40}, [](auto x, auto) { return static_cast<float>(x) / 60; }));
    EXPECT_NEAR(at(ramp.edges, 25, 20), at(ramp.edges, 35, 20), 1e-5);
    EXPECT_GT(at(ramp.edges, 30, 20), 10 * at(ramp.points, 30, 20));
}

TEST(FlipTone, curve_is_inverted) {
    for (double const shown : {0.05, 0.5, 0.85, 0.99}) {
        EXPECT_NEAR(aces_curve(static_cast<float>(aces_curve_inverse(shown))), shown, 1e-6);
    }
    EXPECT_EQ(aces_curve(0), 0);
    EXPECT_EQ(aces_curve(-1), 0);
    for (float const bright : {20.0f, 1e20f, std::numeric_limits<float>::infinity()}) EXPECT_EQ(aces_curve(bright), 1);
}

TEST(FlipTone, exposures_bring_the_largest_and_the_median_luminance_to_the_same_place) {
    ExposureRange const range = flip_exposures(grey({0.001f, 0.01f, 0.01f, 8}));
    double const wanted = aces_curve_inverse(0.85);
    EXPECT_NEAR(range.start, std::log2(wanted / 8), 1e-6);
    EXPECT_NEAR(range.stop, std::log2(wanted / 0.01), 1e-6);
    EXPECT_EQ(range.count, 10); // log2(800) = 9.6
    EXPECT_NEAR(aces_curve(8 * exposure_gain(range, 0)), 0.85, 1e-5);
    EXPECT_NEAR(aces_curve(0.01f * exposure_gain(range, 9)), 0.85, 1e-5);
}

TEST(FlipTone, exposures_follow_the_unit) {
    ExposureRange const range = flip_exposures(grey({1, 2, 3})), brighter = flip_exposures(grey({4, 8, 12}));
    EXPECT_NEAR(brighter.start, range.start - 2, 1e-6);
    EXPECT_NEAR(brighter.stop, range.stop - 2, 1e-6);
    EXPECT_EQ(flip_exposures(grey({1, 1, 1})).count, 2) << "the fewest";
}

TEST(FlipTone, exposures_of_black_sky_end) {
    ExposureRange const night = flip_exposures(grey({0, 0, 0}));
    EXPECT_EQ(night.start, 0);
    EXPECT_EQ(night.count, 1);
    ExposureRange const sky = flip_exposures(grey({0, 0, -1, 5}));
    EXPECT_NEAR(sky.stop - sky.start, 23, 1e-6);
    EXPECT_EQ(sky.count, 23);
    ExposureRange const broken = flip_exposures(grey({1, 1, std::nanf(""), std::numeric_limits<float>::infinity()}));
    EXPECT_EQ(broken.start, flip_exposures(grey({1})).start) << "what is not finite is no light";
}
