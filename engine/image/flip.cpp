#include "image/flip.h"

#include "core/error.h"
#include "image/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace alpenglow {

namespace {

using Color = std::array<double, 3>;
using Matrix = std::array<Color, 3>;
using Kernel = std::vector<double>; ///< odd length, its centre in the middle

/// Linear Rec.709 to XYZ in exact fractions, from the primaries and the D65 white point, as the authors' code has it.
constexpr Matrix XYZ_FROM_RGB{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

Color operator*(Matrix const& m, Color const& v) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return result;
}

Matrix inverse(Matrix const& m) {
    Matrix result{};
    auto const minor = [&](std::size_t r, std::size_t c) {
        return m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3] -
               m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3];
    };
    double const determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) result[c][r] = minor(r, c) / determinant;
    }
    return result;
}

Color xyz_over_white(Color const& rgb) {
    static Color const white = XYZ_FROM_RGB * Color{1, 1, 1};
    Color const xyz = XYZ_FROM_RGB * rgb;
    return {xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]};
}

Color rgb_from_xyz_over_white(Color const& relative) {
    static Color const white = XYZ_FROM_RGB * Color{1, 1, 1};
    static Matrix const rgb_from_xyz = inverse(XYZ_FROM_RGB);
    return rgb_from_xyz * Color{relative[0] * white[0], relative[1] * white[1], relative[2] * white[2]};
}

/// The linear opponent space in which the eye's contrast sensitivity is applied (section 4.1.1 of the paper).
Color ycxcz_from_rgb(Color const& rgb) {
    Color const t = xyz_over_white(rgb);
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Color rgb_from_ycxcz(Color const& c) {
    double const y = (c[0] + 16) / 116;
    return rgb_from_xyz_over_white({y + c[1] / 500, y, y - c[2] / 200});
}

/// CIELAB with the Hunt effect: colours of little light look less colourful (section 4.1.3).
Color hunt_lab_from_rgb(Color const& rgb) {
    constexpr double delta = 6.0 / 29;
    auto const f = [](double t) {
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    Color const t = xyz_over_white(rgb);
    double const lightness = 116 * f(t[1]) - 16;
    return {lightness, 0.01 * lightness * 500 * (f(t[0]) - f(t[1])), 0.01 * lightness * 200 * (f(t[1]) - f(t[2]))};
}

/// The HyAB distance (Abasi, Amani Tehran, Fairchild 2020) of two Hunt-adjusted colours.
double hyab(Color const& a, Color const& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// 0..1 from a HyAB distance: compressed by a power, and small differences given most of the range (section 4.1.4).
double colour_error(double distance) {
    constexpr double power = 0.7, knee = 0.4, knee_value = 0.95;
    static double const largest = std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), power);
    double const compressed = std::pow(distance, power), knee_at = knee * largest;
    if (compressed < knee_at) return compressed * knee_value / knee_at;
    return knee_value + (compressed - knee_at) / (largest - knee_at) * (1 - knee_value);
}

struct Plane {
    Extent extent;
    std::vector<double> values;

    explicit Plane(Extent e) : extent(e), values(e.pixels()) {}
};

/// Along one axis; beyond the edges the last pixel is repeated.
Plane convolve(Plane const& plane, Kernel const& kernel, bool horizontal) {
    long const width = plane.extent.width, height = plane.extent.height, radius = static_cast<long>(kernel.size() / 2);
    Plane result(plane.extent);
    for (long y = 0; y < height; ++y) {
        for (long x = 0; x < width; ++x) {
            double sum = 0;
            for (long k = -radius; k <= radius; ++k) {
                long const sx = horizontal ? std::clamp(x + k, 0L, width - 1) : x,
                           sy = horizontal ? y : std::clamp(y + k, 0L, height - 1);
                sum += kernel[static_cast<std::size_t>(k + radius)] *
                       plane.values[static_cast<std::size_t>(sy * width + sx)];
            }
            result.values[static_cast<std::size_t>(y * width + x)] = sum;
        }
    }
    return result;
}

Plane convolve(Plane const& plane, Kernel const& across, Kernel const& down) {
    return convolve(convolve(plane, across, true), down, false);
}

Kernel sampled(long radius, std::function<double(double)> const& f) {
    Kernel kernel;
    for (long x = -radius; x <= radius; ++x) kernel.push_back(f(static_cast<double>(x)));
    return kernel;
}

/// One Gaussian of a contrast sensitivity function: a, and b in square degrees (Table 1 of the paper).
struct Lobe {
    double a, b;
};

/// Achromatic, red-green, blue-yellow.
constexpr std::array<std::array<Lobe, 2>, 3> SENSITIVITY{
    {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
constexpr double WIDEST_LOBE = 0.04; // [square degrees]

/// The channel as the eye resolves it: the sum of one or two Gaussians, normalized together.
Plane seen(Plane const& plane, std::array<Lobe, 2> const& lobes, double pixels_per_degree) {
    auto const radius =
        static_cast<long>(std::ceil(3 * std::sqrt(WIDEST_LOBE / (2 * M_PI * M_PI)) * pixels_per_degree));
    Plane result(plane.extent);
    double total = 0;
    for (Lobe const lobe : lobes) {
        if (lobe.a == 0) continue;
        Kernel const kernel =
            sampled(radius, [&](double x) { return std::exp(-std::pow(M_PI * x / pixels_per_degree, 2) / lobe.b); });
        double const sum = std::accumulate(kernel.begin(), kernel.end(), 0.0),
                     weight = lobe.a * std::sqrt(M_PI / lobe.b);
        Plane const part = convolve(plane, kernel, kernel);
        for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] += weight * part.values[i];
        total += weight * sum * sum;
    }
    for (double& value : result.values) value /= total;
    return result;
}

using Channels = std::array<Plane, 3>;

Channels opponent_channels(ByteImage const& image) {
    Channels channels{Plane(image.extent), Plane(image.extent), Plane(image.extent)};
    for (std::size_t i = 0; i < image.extent.pixels(); ++i) {
        std::uint8_t const* const p = &image.rgba[i * 4];
        Color const c =
            ycxcz_from_rgb({linear_from_srgb_byte(p[0]), linear_from_srgb_byte(p[1]), linear_from_srgb_byte(p[2])});
        for (std::size_t k = 0; k < 3; ++k) channels[k].values[i] = c[k];
    }
    return channels;
}

std::vector<Color> perceived_colours(Channels const& channels, double pixels_per_degree) {
    Channels const filtered{seen(channels[0], SENSITIVITY[0], pixels_per_degree),
                            seen(channels[1], SENSITIVITY[1], pixels_per_degree),
                            seen(channels[2], SENSITIVITY[2], pixels_per_degree)};
    std::vector<Color> colours(channels[0].values.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        Color rgb = rgb_from_ycxcz({filtered[0].values[i], filtered[1].values[i], filtered[2].values[i]});
        for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
        colours[i] = hunt_lab_from_rgb(rgb);
    }
    return colours;
}

/// Scales the positive values to the sum 1 and the negative ones to -1.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (double const v : kernel) (v > 0 ? positive : negative) += std::abs(v);
    for (double& v : kernel) v /= v > 0 ? positive : std::max(negative, 1e-300);
    return kernel;
}

struct Features {
    std::vector<double> edges, points; ///< magnitude for each pixel
};

/// Edges and points by the first and second derivatives of a Gaussian over the lightness (section 4.2).
Features find_features(Plane const& achromatic, double pixels_per_degree) {
    constexpr double width = 0.082; // [degrees]
    double const sigma = 0.5 * width * pixels_per_degree;
    auto const radius = static_cast<long>(std::ceil(3 * sigma));
    auto const gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    Kernel const smooth = balanced(sampled(radius, gauss));
    Kernel const edge = balanced(sampled(radius, [&](double x) { return -x * gauss(x); }));
    Kernel const point = balanced(sampled(radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * gauss(x); }));

    Plane grey = achromatic;
    for (double& value : grey.values) value = (value + 16) / 116;
    auto const magnitude = [&](Kernel const& kernel) {
        Plane result = convolve(grey, kernel, smooth);
        Plane const down = convolve(grey, smooth, kernel);
        for (std::size_t i = 0; i < result.values.size(); ++i)
            result.values[i] = std::hypot(result.values[i], down.values[i]);
        return result.values;
    };
    return {magnitude(edge), magnitude(point)};
}

void summarize(FlipResult& result) {
    std::vector<float> sorted = result.error;
    std::sort(sorted.begin(), sorted.end());
    result.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    result.median = static_cast<double>(sorted[sorted.size() / 2]);
    result.largest = static_cast<double>(sorted.back());
}

} // namespace

FlipResult compute_flip(ByteImage const& reference, ByteImage const& test, double pixels_per_degree) {
    if (reference.extent != test.extent || reference.extent.pixels() == 0) {
        throw Error(ErrorKind::bad_input, "FLIP needs two pictures of one size");
    }
    Channels const channels_a = opponent_channels(reference), channels_b = opponent_channels(test);
    std::vector<Color> const colours_a = perceived_colours(channels_a, pixels_per_degree);
    std::vector<Color> const colours_b = perceived_colours(channels_b, pixels_per_degree);
    Features const a = find_features(channels_a[0], pixels_per_degree),
                   b = find_features(channels_b[0], pixels_per_degree);

    FlipResult result;
    result.extent = reference.extent;
    for (std::size_t i = 0; i < colours_a.size(); ++i) {
        double const feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
        double const exponent = 1 - std::sqrt(std::min(feature / M_SQRT2, 1.0));
        result.error.push_back(static_cast<float>(std::pow(colour_error(hyab(colours_a[i], colours_b[i])), exponent)));
    }
    summarize(result);
    return result;
}

} // namespace alpenglow
