#include "image/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace alpenglow::flip {

namespace {

/// Adds `weight` times the `count` values at `from`.
void add_scaled(float* into, float const* from, std::size_t count, float weight) {
    for (std::size_t i = 0; i < count; ++i) into[i] += weight * from[i];
}

Plane convolve_rows(Plane const& plane, Kernel const& kernel) {
    std::size_t const width = plane.extent.width, radius = kernel.size() / 2;
    Plane result(plane.extent);
    std::vector<float> padded(width + 2 * radius);
    for (std::size_t y = 0; y < plane.extent.height; ++y) {
        float const* const row = &plane.values[y * width];
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, width, padded.begin() + static_cast<long>(radius));
        std::fill_n(padded.end() - static_cast<long>(radius), radius, row[width - 1]);
        for (std::size_t k = 0; k < kernel.size(); ++k)
            add_scaled(&result.values[y * width], &padded[k], width, kernel[k]);
    }
    return result;
}

Plane convolve_columns(Plane const& plane, Kernel const& kernel) {
    std::size_t const width = plane.extent.width;
    long const height = plane.extent.height, radius = static_cast<long>(kernel.size() / 2);
    Plane result(plane.extent);
    for (long y = 0; y < height; ++y) {
        float* const row = &result.values[static_cast<std::size_t>(y) * width];
        for (long k = -radius; k <= radius; ++k) {
            auto const from = static_cast<std::size_t>(std::clamp(y + k, 0L, height - 1));
            add_scaled(row, &plane.values[from * width], width, kernel[static_cast<std::size_t>(k + radius)]);
        }
    }
    return result;
}

using Samples = std::vector<double>;

Samples sampled(long radius, std::function<double(double)> const& f) {
    Samples samples;
    for (long x = -radius; x <= radius; ++x) samples.push_back(f(static_cast<double>(x)));
    return samples;
}

Kernel kernel_of(Samples const& samples) { return Kernel(samples.begin(), samples.end()); }

/// Scales the positive values to the sum 1 and the negative ones to -1.
Kernel balanced(Samples samples) {
    double positive = 0, negative = 0;
    for (double const v : samples) (v > 0 ? positive : negative) += std::abs(v);
    for (double& v : samples) {
        if (v != 0) v /= v > 0 ? positive : negative;
    }
    return kernel_of(samples);
}

/// One Gaussian of a contrast sensitivity function: a, and b in square degrees.
struct Gaussian {
    double a, b;
};

constexpr std::array<std::array<Gaussian, 2>, 3> SENSITIVITIES{
    {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
constexpr double WIDEST = 0.04; // [square degrees]

Sensitivity make_sensitivity(std::array<Gaussian, 2> const& gaussians, double pixels_per_degree) {
    auto const radius = static_cast<long>(std::ceil(3 * std::sqrt(WIDEST / (2 * M_PI * M_PI)) * pixels_per_degree));
    Sensitivity result;
    double total = 0;
    for (Gaussian const g : gaussians) {
        if (g.a == 0) continue;
        Samples const samples =
            sampled(radius, [&](double x) { return std::exp(-std::pow(M_PI * x / pixels_per_degree, 2) / g.b); });
        double const sum = std::accumulate(samples.begin(), samples.end(), 0.0), weight = g.a * std::sqrt(M_PI / g.b);
        result.push_back({static_cast<float>(weight), kernel_of(samples)});
        total += weight * sum * sum;
    }
    for (Lobe& lobe : result) lobe.weight /= static_cast<float>(total);
    return result;
}

/// The length of (a, b), in place of a.
void take_magnitude(Plane& a, Plane const& b) {
    for (std::size_t i = 0; i < a.values.size(); ++i)
        a.values[i] = std::sqrt(a.values[i] * a.values[i] + b.values[i] * b.values[i]);
}

} // namespace

Plane convolve(Plane const& plane, Kernel const& across, Kernel const& down) {
    return convolve_columns(convolve_rows(plane, across), down);
}

Filters::Filters(double pixels_per_degree)
    : sensitivity{make_sensitivity(SENSITIVITIES[0], pixels_per_degree),
                  make_sensitivity(SENSITIVITIES[1], pixels_per_degree),
                  make_sensitivity(SENSITIVITIES[2], pixels_per_degree)} {
    constexpr double width = 0.082; // [degrees]
    double const sigma = 0.5 * width * pixels_per_degree;
    auto const radius = static_cast<long>(std::ceil(3 * sigma));
    auto const gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    smooth = balanced(sampled(radius, gauss));
    edge = balanced(sampled(radius, [&](double x) { return -x * gauss(x); }));
    point = balanced(sampled(radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * gauss(x); }));
}

Plane resolved(Sensitivity const& sensitivity, Plane const& plane) {
    Plane result(plane.extent);
    for (Lobe const& lobe : sensitivity) {
        Plane const part = convolve(plane, lobe.kernel, lobe.kernel);
        add_scaled(result.values.data(), part.values.data(), part.values.size(), lobe.weight);
    }
    return result;
}

Features find_features(Filters const& filters, Plane const& lightness) {
    Plane const smoothed = convolve_rows(lightness, filters.smooth);
    Features features{convolve(lightness, filters.edge, filters.smooth),
                      convolve(lightness, filters.point, filters.smooth)};
    take_magnitude(features.edges, convolve_columns(smoothed, filters.edge));
    take_magnitude(features.points, convolve_columns(smoothed, filters.point));
    return features;
}

} // namespace alpenglow::flip
