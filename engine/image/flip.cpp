#include "image/flip.h"

#include "core/error.h"
#include "core/parallel.h"
#include "image/color.h"
#include "image/compare.h"
#include "image/flip_color.h"
#include "image/flip_filters.h"
#include "image/flip_tone.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace alpenglow {

namespace {

using namespace flip;

/// Each colour channel through the display's curve, to 0..1 in linear light; black where a pixel is not finite.
template <typename Curve> FloatImage displayed(FloatImage image, Curve curve) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        float* const rgb = &image.rgba[i];
        bool const finite = is_finite_color(rgb);
        for (std::size_t k = 0; k < 3; ++k) rgb[k] = finite ? curve(rgb[k]) : 0;
    }
    return image;
}

/// A picture as FLIP's eye has it.
struct Seen {
    std::vector<Color> colors; ///< Hunt-adjusted CIELAB of what the eye resolves
    Features features;
};

std::array<Plane, 3> opponent_channels(FloatImage const& image) {
    std::array<Plane, 3> channels{Plane(image.extent), Plane(image.extent), Plane(image.extent)};
    for (std::size_t i = 0; i < image.extent.pixels(); ++i) {
        float const* const p = &image.rgba[i * 4];
        Color const c = ycxcz_from_rgb({p[0], p[1], p[2]});
        for (std::size_t k = 0; k < 3; ++k) channels[k].values[i] = c[k];
    }
    return channels;
}

Seen see(Filters const& filters, FloatImage const& image) {
    std::array<Plane, 3> channels = opponent_channels(image);
    Plane lightness = channels[0];
    for (float& value : lightness.values) value = (value + 16) / 116;
    for (std::size_t k = 0; k < 3; ++k) channels[k] = resolved(filters.sensitivity[k], channels[k]);

    Seen seen{std::vector<Color>(image.extent.pixels()), find_features(filters, lightness)};
    for (std::size_t i = 0; i < seen.colors.size(); ++i) {
        Color rgb = rgb_from_ycxcz({channels[0].values[i], channels[1].values[i], channels[2].values[i]});
        for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
        seen.colors[i] = hunt_lab_from_rgb(rgb);
    }
    return seen;
}

/// The colour's error, raised where an edge or a point is in one picture only.
float error_of(Seen const& a, Seen const& b, std::size_t i) {
    float const edge = std::abs(a.features.edges.values[i] - b.features.edges.values[i]);
    float const point = std::abs(a.features.points.values[i] - b.features.points.values[i]);
    float const feature = std::min(std::max(edge, point) / static_cast<float>(M_SQRT2), 1.0f);
    return std::pow(color_error(hyab(a.colors[i], b.colors[i])), 1 - std::sqrt(feature));
}

std::vector<float> error_map(Filters const& filters, FloatImage const& reference, FloatImage const& test) {
    Seen const a = see(filters, reference), b = see(filters, test);
    std::vector<float> errors(a.colors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = error_of(a, b, i);
    return errors;
}

void require_comparable(Extent reference, Extent test) {
    require_same_extent(test, reference);
    if (reference.pixels() == 0) throw Error(ErrorKind::bad_input, "FLIP needs pictures with pixels");
}

void mark_non_finite(FlipResult& result, FloatImage const& reference, FloatImage const& test) {
    for (std::size_t i = 0; i < result.error.size(); ++i) {
        if (!is_finite_color(&reference.rgba[i * 4]) || !is_finite_color(&test.rgba[i * 4])) result.error[i] = 1;
    }
}

void summarize(FlipResult& result) {
    std::vector<float> sorted = result.error;
    std::sort(sorted.begin(), sorted.end());
    result.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    result.median = static_cast<double>(sorted[sorted.size() / 2]);
    result.largest = static_cast<double>(sorted.back());
}

} // namespace

FlipResult compute_flip(FloatImage const& reference, FloatImage const& test, double pixels_per_degree) {
    require_comparable(reference.extent, test.extent);
    FlipResult result;
    result.extent = reference.extent;
    auto const clamped = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
    result.error = error_map(Filters(pixels_per_degree), displayed(reference, clamped), displayed(test, clamped));
    mark_non_finite(result, reference, test);
    summarize(result);
    return result;
}

FlipResult compute_flip(ByteImage const& reference, ByteImage const& test, double pixels_per_degree) {
    return compute_flip(linear_from_srgb(reference), linear_from_srgb(test), pixels_per_degree);
}

HdrFlipResult compute_hdr_flip(FloatImage const& reference, FloatImage const& test, double pixels_per_degree) {
    require_comparable(reference.extent, test.extent);
    Filters const filters(pixels_per_degree);
    HdrFlipResult result;
    result.extent = reference.extent;
    result.exposures = flip_exposures(reference);
    result.error.resize(reference.extent.pixels());
    std::mutex merging; // a maximum is the same in any order
    parallel_for(result.exposures.count, 0, [&](int i) {
        auto const shown = [gain = exposure_gain(result.exposures, i)](float v) { return aces_curve(gain * v); };
        std::vector<float> const errors = error_map(filters, displayed(reference, shown), displayed(test, shown));
        std::lock_guard const lock(merging);
        for (std::size_t k = 0; k < errors.size(); ++k) result.error[k] = std::max(result.error[k], errors[k]);
    });
    mark_non_finite(result, reference, test);
    summarize(result);
    return result;
}

} // namespace alpenglow
