#include "image/metrics.h"

#include "core/error.h"
#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alpenglow {

namespace {

struct Sums {
    std::size_t pixels = 0; ///< finite in both
    std::array<double, 3> reference{}, difference{};
    double squares = 0;
    double peak = 0;            ///< the reference's largest
    std::vector<double> errors; ///< absolute, of each channel

    void add(float const* test, float const* wanted) {
        ++pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            double const r = double{wanted[c]}, d = double{test[c]} - r;
            reference[c] += r;
            difference[c] += d;
            squares += d * d;
            peak = std::max(peak, r);
            errors.push_back(std::abs(d));
        }
    }
};

Sums sum_up(FloatImage const& test, FloatImage const& reference) {
    Sums sums;
    sums.errors.reserve(3 * reference.extent.pixels());
    for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
        float const *const a = &test.rgba[i], *const b = &reference.rgba[i];
        if (is_finite_color(a) && is_finite_color(b)) sums.add(a, b);
    }
    return sums;
}

double percentile(std::vector<double>& values, double share) {
    auto const rank = static_cast<long>(std::ceil(share * static_cast<double>(values.size())));
    auto const place = values.begin() + std::max(rank, 1L) - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

std::optional<double> ratio(double numerator, double denominator) {
    if (denominator == 0) return {};
    return numerator / denominator;
}

} // namespace

Metrics measure(FloatImage const& test, FloatImage const& reference, std::optional<double> peak) {
    require_same_extent(test.extent, reference.extent);
    if (reference.extent.pixels() == 0) throw Error(ErrorKind::bad_input, "pictures without pixels can't be compared");

    Sums sums = sum_up(test, reference);
    Metrics result;
    result.non_finite = 1 - static_cast<double>(sums.pixels) / static_cast<double>(reference.extent.pixels());
    if (sums.pixels == 0) return result;

    double const values = 3 * static_cast<double>(sums.pixels), mse = sums.squares / values;
    double const mean = (sums.reference[0] + sums.reference[1] + sums.reference[2]) / values;
    double const top = peak.value_or(sums.peak);
    result.mse = mse;
    result.rmse = std::sqrt(mse);
    result.rel_rmse = ratio(std::sqrt(mse), mean);
    if (top > 0) result.psnr = 10 * std::log10(top * top / mse);
    for (std::size_t c = 0; c < 3; ++c) result.bias[c] = ratio(sums.difference[c], sums.reference[c]);
    result.p999 = percentile(sums.errors, 0.999);
    return result;
}

} // namespace alpenglow
