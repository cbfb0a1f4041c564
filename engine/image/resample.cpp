#include "image/resample.h"

#include "core/error.h"
#include "image/color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace alpenglow {

namespace {

struct Tap {
    std::uint32_t source;
    float weight; ///< of one output pixel these sum to 1
};

/// For each output pixel along one axis, the source pixels that it covers.
std::vector<std::vector<Tap>> area_taps(std::uint32_t from, std::uint32_t to) {
    double const ratio = static_cast<double>(from) / to;
    std::vector<std::vector<Tap>> taps(to);
    for (std::uint32_t i = 0; i < to; ++i) {
        double const first = i * ratio, last = std::min<double>((i + 1) * ratio, from);
        for (auto s = static_cast<std::uint32_t>(first); s < from && s < last; ++s) {
            double const covered = std::min<double>(s + 1, last) - std::max<double>(s, first);
            taps[i].push_back({s, static_cast<float>(covered / (last - first))});
        }
    }
    return taps;
}

void add_scaled(float* into, float const* pixel, float weight) {
    for (int c = 0; c < 4; ++c) into[c] += weight * pixel[c];
}

FloatImage resample_rows(FloatImage const& picture, std::uint32_t width) {
    auto const taps = area_taps(picture.extent.width, width);
    FloatImage result({width, picture.extent.height});
    for (std::uint32_t y = 0; y < picture.extent.height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            for (Tap const tap : taps[x]) add_scaled(result.at(x, y), picture.at(tap.source, y), tap.weight);
        }
    }
    return result;
}

FloatImage resample_columns(FloatImage const& picture, std::uint32_t height) {
    auto const taps = area_taps(picture.extent.height, height);
    FloatImage result({picture.extent.width, height});
    for (std::uint32_t y = 0; y < height; ++y) {
        for (Tap const tap : taps[y]) {
            for (std::uint32_t x = 0; x < picture.extent.width; ++x) {
                add_scaled(result.at(x, y), picture.at(x, tap.source), tap.weight);
            }
        }
    }
    return result;
}

} // namespace

ByteImage resample(ByteImage const& picture, Extent extent) {
    if (picture.extent.pixels() == 0 || extent.pixels() == 0) {
        throw Error(ErrorKind::bad_input, "a picture without pixels can't be resampled");
    }
    if (picture.extent == extent) return picture;
    FloatImage const narrowed = resample_rows(linear_from_srgb(picture), extent.width);
    return srgb_from_linear(resample_columns(narrowed, extent.height));
}

} // namespace alpenglow
