#include "support/statistics.h"

#include <gtest/gtest.h>

#include <random>

using namespace alpenglow::test;

TEST(Statistics, tail_of_chi_square_is_the_closed_forms) {
    for (double const x : {0.1, 1.0, 5.0, 40.0}) {
        EXPECT_NEAR(chi_square_tail(x, 1), std::erfc(std::sqrt(x / 2)), 1e-12);
        EXPECT_NEAR(chi_square_tail(x, 2), std::exp(-x / 2), 1e-12);
        EXPECT_NEAR(chi_square_tail(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-12);
    }
    // Abramowitz and Stegun 1964, table 26.8: the upper 5 % point of 100 degrees.
    EXPECT_NEAR(chi_square_tail(124.342, 100), 0.05, 1e-5);
}

TEST(Statistics, tails_of_normal_numbers_are_even) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 3);
    double mean = 0, tails[10] = {};
    for (int i = 0; i < 1000; ++i) {
        ChiSquare sum;
        for (int k = 0; k < 30; ++k) sum.add(normal(random), 9);
        mean += sum.tail() / 1000;
        ++tails[static_cast<int>(sum.tail() * 10)];
    }
    EXPECT_NEAR(mean, 0.5, 4 * std::sqrt(1.0 / 12 / 1000));
    ChiSquare even;
    for (double const n : tails) even.add(n - 100, 100);
    EXPECT_GT(chi_square_tail(even.statistic, 9), 1e-3);
}

TEST(Statistics, a_tally_has_mean_and_variance) {
    Tally tally;
    for (double const x : {1.0, 2.0, 3.0, 6.0}) tally.add(x);
    EXPECT_DOUBLE_EQ(tally.mean(), 3);
    EXPECT_DOUBLE_EQ(tally.variance(), 14.0 / 3 / 4);
}
