#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace alpenglow::test {

/// The regularised upper incomplete gamma function, 0 < a, 0 <= x (Abramowitz and Stegun 1964, 6.5.29 and 6.5.31).
inline double upper_gamma(double a, double x) {
    constexpr double EPSILON = std::numeric_limits<double>::epsilon();
    if (x <= 0) return 1;
    double const scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (double n = a + 1; term > sum * EPSILON; ++n) sum += term *= x / n;
        return 1 - scale * sum;
    }
    // The continued fraction, from its front (Lentz 1976).
    double b = x + 1 - a, c = 1 / std::numeric_limits<double>::min(), d = 1 / b, value = d, change = 0;
    for (int n = 1; std::abs(change - 1) > EPSILON && n < 100000; ++n) {
        double const numerator = n * (a - n);
        b += 2;
        d = 1 / (b + numerator * d);
        c = b + numerator / c;
        value *= change = c * d;
    }
    return scale * value;
}

/// How likely a chi-square sum of `degrees` squares of standard normal numbers is to be `statistic` or more.
inline double chi_square_tail(double statistic, double degrees) { return upper_gamma(0.5 * degrees, 0.5 * statistic); }

/// How likely a standard normal number is to be as far from 0 as z or farther.
inline double normal_tail(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

/// Squared differences over their variances, summed.
struct ChiSquare {
    double statistic = 0;
    int degrees = 0;

    /// `variance` is that of `difference`; where it is 0 the difference has to be 0.
    void add(double difference, double variance) {
        if (difference == 0 && variance == 0) return;
        statistic += difference * difference / variance, ++degrees;
    }
    double tail() const { return chi_square_tail(statistic, degrees); }
};

/// A running mean with its variance (Welford 1962).
class Tally {
public:
    void add(double x) {
        ++count_;
        double const before = x - mean_;
        mean_ += before / count_;
        squares_ += before * (x - mean_);
    }
    double mean() const { return mean_; }
    /// Of the mean, not of one sample.
    double variance() const { return squares_ / (count_ - 1) / count_; }
    double deviation() const { return std::sqrt(variance()); }

private:
    double count_ = 0, mean_ = 0, squares_ = 0;
};

} // namespace alpenglow::test
