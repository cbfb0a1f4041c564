#include "image/mipmaps.h"

#include "core/parallel.h"
#include "image/color.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace alpenglow {

namespace {

constexpr std::uint32_t WHITE = 65535;     // linear light as whole numbers
constexpr int ENCODE_SHIFT = 2;            // a step of 6e-5: a fifth of the narrowest step of sRGB
constexpr std::uint32_t CHUNK = 32;        // rows of a level that one thread takes at a time

/// Bytes as linear light and back.
struct Transfer {
    std::array<std::uint16_t, 256> linear{};
    std::array<std::uint8_t, (WHITE >> ENCODE_SHIFT) + 1> byte{};

    std::uint32_t light(std::uint8_t value) const { return linear[value]; }
    std::uint8_t encoded(std::uint64_t mean) const { return byte[mean >> ENCODE_SHIFT]; }

    explicit Transfer(bool srgb) {
        for (std::size_t i = 0; i < linear.size(); ++i) {
            float const light = srgb ? linear_from_srgb_byte(static_cast<std::uint8_t>(i)) : static_cast<float>(i) / 255;
            linear[i] = static_cast<std::uint16_t>(std::lround(light * WHITE));
        }
        for (std::size_t i = 0; i < byte.size(); ++i) {
            float const light = (static_cast<float>(i) + 0.5f) / static_cast<float>(byte.size());
            byte[i] = srgb ? srgb_byte_from_linear(light) : static_cast<std::uint8_t>(std::lround(light * 255));
        }
    }
};

/// Words are linear light already.
struct Plain {
    static std::uint32_t light(std::uint16_t value) { return value; }
    static std::uint16_t encoded(std::uint64_t mean) { return static_cast<std::uint16_t>(mean); }
};

Transfer const& transfer(ByteImage const&, bool srgb) {
    static Transfer const encoded(true), plain(false);
    return srgb ? encoded : plain;
}
Plain transfer(DeepImage const&, bool) { return {}; }

template <class Image> struct Source {
    using Value = typename decltype(Image::rgba)::value_type;

    Extent extent;
    Value const* rgba;

    Value const* at(std::uint32_t x, std::uint32_t y) const {
        return rgba + (std::size_t{y} * extent.width + x) * 4;
    }
};

/// Texels of one axis that a texel of the next level covers; weights add up to `total`.
struct Taps {
    std::uint32_t first = 0, count = 1;
    std::array<std::uint64_t, 3> weights{1};
    std::uint64_t total = 1;
};

Taps taps_at(std::uint32_t i, std::uint32_t size) {
    if (size == 1) return {};
    if (size % 2 == 0) return {2 * i, 2, {1, 1}, 2};
    std::uint32_t const half = size / 2;
    return {2 * i, 3, {half - i, half, i + 1}, size};
}

/// Where both sides are even; this is what nearly all time is spent on.
template <class Image, class Encoding>
void average_even_row(Source<Image> const& from, Image& to, std::uint32_t y, Encoding const& color,
                      Encoding const& alpha) {
    auto const *upper = from.at(0, 2 * y), *lower = from.at(0, 2 * y + 1);
    auto* texel = to.at(0, y);
    auto const mean = [&](Encoding const& t, int c) {
        return t.encoded((t.light(upper[c]) + t.light(upper[c + 4]) + t.light(lower[c]) + t.light(lower[c + 4])) >> 2);
    };
    for (std::uint32_t x = 0; x < to.extent.width; ++x, upper += 8, lower += 8, texel += 4) {
        for (int c = 0; c < 3; ++c) texel[c] = mean(color, c);
        texel[3] = mean(alpha, 3);
    }
}

template <class Image, class Encoding>
void average_row(Source<Image> const& from, Image& to, std::uint32_t y, Encoding const& color,
                 Encoding const& alpha) {
    Taps const down = taps_at(y, from.extent.height);
    for (std::uint32_t x = 0; x < to.extent.width; ++x) {
        Taps const across = taps_at(x, from.extent.width);
        for (int c = 0; c < 4; ++c) {
            Encoding const& t = c < 3 ? color : alpha;
            std::uint64_t sum = 0;
            for (std::uint32_t v = 0; v < down.count; ++v) {
                for (std::uint32_t u = 0; u < across.count; ++u) {
                    std::uint64_t const weight = down.weights[v] * across.weights[u];
                    sum += weight * t.light(from.at(across.first + u, down.first + v)[c]);
                }
            }
            to.at(x, y)[c] = t.encoded(sum / (down.total * across.total));
        }
    }
}

template <class Image> Image next_level(Source<Image> const& from, bool srgb) {
    Image to({std::max(from.extent.width / 2, 1u), std::max(from.extent.height / 2, 1u)});
    bool const even = from.extent.width % 2 == 0 && from.extent.height % 2 == 0;
    auto const &color = transfer(to, srgb), &alpha = transfer(to, false);
    std::uint32_t const chunks = (to.extent.height + CHUNK - 1) / CHUNK;
    parallel_for(static_cast<int>(chunks), 0, [&](int chunk) {
        std::uint32_t const begin = static_cast<std::uint32_t>(chunk) * CHUNK;
        for (std::uint32_t y = begin; y < std::min(begin + CHUNK, to.extent.height); ++y)
            even ? average_even_row(from, to, y, color, alpha) : average_row(from, to, y, color, alpha);
    });
    return to;
}

template <class Image>
std::vector<Image> levels_below(Source<Image> from, bool srgb) {
    std::vector<Image> levels;
    levels.reserve(static_cast<std::size_t>(std::bit_width(std::max(from.extent.width, from.extent.height))));
    while (std::max(from.extent.width, from.extent.height) > 1) {
        levels.push_back(next_level(from, srgb));
        from = {levels.back().extent, levels.back().rgba.data()};
    }
    return levels;
}

} // namespace

std::vector<ByteImage> mip_levels(Extent extent, std::span<std::uint8_t const> rgba, bool srgb) {
    assert(rgba.size() == extent.pixels() * 4);
    return levels_below<ByteImage>({extent, rgba.data()}, srgb);
}

std::vector<DeepImage> mip_levels(Extent extent, std::span<std::uint16_t const> rgba, [[maybe_unused]] bool srgb) {
    assert(rgba.size() == extent.pixels() * 4 && !srgb);
    return levels_below<DeepImage>({extent, rgba.data()}, false);
}

} // namespace alpenglow
