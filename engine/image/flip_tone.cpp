#include "image/flip_tone.h"

#include "image/color.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace flip {

namespace {

/// (A x² + B x) / (C x² + D x + E)
constexpr double A = 0.6 * 0.6 * 2.51, B = 0.6 * 0.03, C = 0.6 * 0.6 * 2.43, D = 0.6 * 0.59, E = 0.14;

} // namespace

float aces_curve(float exposed) {
    // Above 13 the curve is beyond 1, and far above its squares overflow.
    float const x = std::clamp(exposed, 0.0f, 100.0f);
    constexpr auto a = static_cast<float>(A), b = static_cast<float>(B), c = static_cast<float>(C),
                   d = static_cast<float>(D), e = static_cast<float>(E);
    return std::min(x * (a * x + b) / (x * (c * x + d) + e), 1.0f);
}

double aces_curve_inverse(double shown) {
    double const a = A - shown * C, b = B - shown * D, c = -shown * E;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

float exposure_gain(ExposureRange const& range, int i) {
    double const step = range.count > 1 ? (range.stop - range.start) / (range.count - 1) : 0;
    return static_cast<float>(std::exp2(range.start + i * step));
}

} // namespace flip

ExposureRange flip_exposures(FloatImage const& reference) {
    constexpr double shown = 0.85, smallest_median = 0x1p-23;
    std::vector<float> luminances;
    luminances.reserve(reference.extent.pixels());
    for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
        float const* const p = &reference.rgba[i];
        float const y = luminance(p[0], p[1], p[2]);
        luminances.push_back(std::isfinite(y) ? std::max(y, 0.0f) : 0.0f);
    }
    if (luminances.empty()) return {};
    double const largest = static_cast<double>(*std::max_element(luminances.begin(), luminances.end()));
    if (largest == 0) return {};
    auto const middle = luminances.begin() + static_cast<long>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    double const median = std::max(static_cast<double>(*middle), smallest_median * largest);

    double const wanted = flip::aces_curve_inverse(shown), start = std::log2(wanted / largest),
                 stop = std::log2(wanted / median);
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

} // namespace alpenglow
