#include "reference/chapman_table.h"

#include "reference/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

/// Of a radius to the next, relatively. The nodes hardly depend on it: they are interpolated linearly.
constexpr double RADIUS_STEP = 2.5e-3;
constexpr int LEAST_RADII = 8, MOST_RADII = 512;
constexpr int COSINES = 384;  ///< in x = width / (mu + width), even from 0 to 1
constexpr int POINTS = 4;     ///< of the interpolation in x

/// Cosine with the horizon below which the planet's curvature counts: sqrt(2 H / (pi r)). The path is nearly
/// H / (mu + width).
double width_of(double radius, double scale_height) { return std::sqrt(2 * scale_height / (M_PI * radius)); }

/// By Gauss-Legendre panels in v, s = s_max v^2: dense where the ray starts.
double integrate_path(double r, double mu, double scale_height) {
    constexpr int panels = 24;
    double const gain = 42 * scale_height; // e^-42 is 6e-19
    double const longest = std::sqrt(r * r * mu * mu + 2 * r * gain + gain * gain) - r * mu;
    auto const integrand = [&](double v) {
        double const s = longest * v * v;
        // r(s) - r without cancellation.
        double const climbed = s * (2 * r * mu + s) / (std::sqrt(r * r + s * (2 * r * mu + s)) + r);
        return std::exp(-climbed / scale_height) * 2 * longest * v;
    };
    double sum = 0;
    for (int i = 0; i < panels; ++i) sum += gauss_legendre(integrand, double(i) / panels, double(i + 1) / panels);
    return sum;
}

/// 1 / product of (i - k) over k != i, for even nodes at 0, 1, …, N - 1.
template <int N> constexpr std::array<double, N> lagrange_factors() {
    std::array<double, N> factors{};
    for (int i = 0; i < N; ++i) {
        double product = 1;
        for (int k = 0; k < N; ++k) product *= k != i ? i - k : 1;
        factors[static_cast<std::size_t>(i)] = 1 / product;
    }
    return factors;
}

/// Weights of the polynomial through `N` such nodes.
template <int N> std::array<double, N> lagrange_weights(double x) {
    static constexpr std::array<double, N> factors = lagrange_factors<N>();
    std::array<double, N> weights;
    double below = 1; // product of (x - k) for k < i
    for (std::size_t i = 0; i < N; ++i) {
        weights[i] = factors[i] * below;
        below *= x - double(i);
    }
    double above = 1;
    for (std::size_t i = N; i-- > 0;) {
        weights[i] *= above;
        above *= x - double(i);
    }
    return weights;
}

int radii_between(double lowest, double highest) {
    double const steps = std::ceil((highest - lowest) / (RADIUS_STEP * lowest));
    return static_cast<int>(std::clamp(steps + 1, double(LEAST_RADII), double(MOST_RADII)));
}

} // namespace

ChapmanTable::ChapmanTable(double lowest, double highest, double scale_height)
    : rows_(radii_between(lowest, highest)), lowest_(lowest), scale_height_(scale_height),
      rows_per_metre_((rows_ - 1) / (highest - lowest)), nodes_(rows_ * COSINES) {
    for (int i = 0; i < rows_; ++i) {
        double const r = lowest + i / rows_per_metre_, width = width_of(r, scale_height);
        nodes_[i * COSINES] = 1 + scale_height / r; // the limit of endless mu: a climb c takes (c + c^2 / (2 r)) / mu
        for (int k = 1; k < COSINES; ++k) {
            double const x = double(k) / (COSINES - 1), mu = width / x - width;
            nodes_[i * COSINES + k] = integrate_path(r, mu, scale_height) / scale_height * (mu + width);
        }
    }
}

double ChapmanTable::path(double radius, double mu) const {
    double const width = width_of(radius, scale_height_);
    double const over = 1 / (mu + width);
    double const row = (radius - lowest_) * rows_per_metre_, column = width * over * (COSINES - 1);
    int const first_row = std::clamp(static_cast<int>(row), 0, rows_ - 2);
    int const first_column = std::clamp(static_cast<int>(column) - POINTS / 2 + 1, 0, COSINES - POINTS);
    double const between = row - first_row;
    auto const columns = lagrange_weights<POINTS>(column - first_column);
    double const* const node = &nodes_[first_row * COSINES + first_column];
    double sum = 0;
    for (int k = 0; k < POINTS; ++k) sum += columns[k] * ((1 - between) * node[k] + between * node[k + COSINES]);
    return sum * scale_height_ * over;
}

} // namespace alpenglow
