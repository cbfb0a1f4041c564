#include "image/compare.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace alpenglow {

namespace {

std::string text(Extent e) { return std::to_string(e.width) + "x" + std::to_string(e.height); }

/// The largest difference of a pixel's three colour channels; their sum is added to `sum`.
int pixel_difference(std::uint8_t const* a, std::uint8_t const* b, std::uint64_t& sum) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) {
        int const difference = std::abs(a[c] - b[c]);
        largest = std::max(largest, difference);
        sum += static_cast<std::uint64_t>(difference);
    }
    return largest;
}

void place(ByteImage& into, ByteImage const& picture, std::uint32_t left) {
    for (std::uint32_t y = 0; y < picture.extent.height; ++y) {
        std::copy_n(picture.at(0, y), std::size_t{picture.extent.width} * 4, into.at(left, y));
    }
}

} // namespace

void require_same_extent(Extent a, Extent b) {
    if (a == b) return;
    throw Error(ErrorKind::bad_input, "pictures of " + text(a) + " and " + text(b) + " can't be compared", {},
                "give two of one size");
}

ByteDifference compare(ByteImage const& a, ByteImage const& b, int tolerance) {
    require_same_extent(a.extent, b.extent);
    ByteDifference result;
    std::size_t above = 0;
    std::uint64_t sum = 0;
    for (std::uint32_t y = 0; y < a.extent.height; ++y) {
        for (std::uint32_t x = 0; x < a.extent.width; ++x) {
            int const difference = pixel_difference(a.at(x, y), b.at(x, y), sum);
            above += difference > tolerance;
            if (difference > result.largest) result.largest = difference, result.x = x, result.y = y;
        }
    }
    double const pixels = static_cast<double>(std::max<std::size_t>(a.extent.pixels(), 1));
    result.mean = static_cast<double>(sum) / (3 * pixels);
    result.share_above = static_cast<double>(above) / pixels;
    return result;
}

FloatDifference compare(FloatImage const& a, FloatImage const& b) {
    require_same_extent(a.extent, b.extent);
    FloatDifference result;
    double squares = 0;
    bool finite = true;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        double const difference = std::abs(double{a.rgba[i]} - double{b.rgba[i]});
        finite = finite && std::isfinite(difference);
        result.largest = std::max(result.largest, difference);
        result.mean += difference;
        result.mean_a += double{a.rgba[i]};
        squares += difference * difference;
    }
    double const values = 3 * static_cast<double>(std::max<std::size_t>(a.extent.pixels(), 1));
    result.mean /= values;
    result.mean_a /= values;
    result.rmse = std::sqrt(squares / values);
    if (!finite) result.largest = result.mean = result.rmse = std::numeric_limits<double>::infinity();
    return result;
}

bool is_finite_color(float const* rgb) {
    return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

std::size_t count_non_finite(FloatImage const& image) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        count += !std::all_of(&image.rgba[i], &image.rgba[i] + 4, [](float v) { return std::isfinite(v); });
    }
    return count;
}

ByteImage difference_picture(ByteImage const& a, ByteImage const& b, double gain) {
    require_same_extent(a.extent, b.extent);
    ByteImage result(a.extent);
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        double const scaled = gain * std::abs(a.rgba[i] - b.rgba[i]);
        result.rgba[i] = i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(std::min(255.0, scaled));
    }
    return result;
}

ByteImage side_by_side(ByteImage const& a, ByteImage const& b, double gain) {
    constexpr std::uint32_t gap = 4;
    constexpr std::uint8_t grey = 128;
    ByteImage const difference = difference_picture(a, b, gain);
    ByteImage result({3 * a.extent.width + 2 * gap, a.extent.height});
    std::fill(result.rgba.begin(), result.rgba.end(), grey);
    for (std::size_t i = 3; i < result.rgba.size(); i += 4) result.rgba[i] = 255;
    place(result, a, 0);
    place(result, b, a.extent.width + gap);
    place(result, difference, 2 * (a.extent.width + gap));
    return result;
}

} // namespace alpenglow
