#pragma once

#include "image/image.h"

#include <cstddef>
#include <string_view>
#include <vector>
#include <zlib.h>

namespace alpenglow::test {

/// A PNG of 16 bits a channel, RGBA.
inline std::vector<std::byte> deep_png(DeepImage const& image) {
    std::vector<std::byte> png;
    auto const append = [](std::vector<std::byte>& to, std::uint64_t value, int size) {
        for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) to.push_back(static_cast<std::byte>(value >> shift));
    };
    auto const add_chunk = [&](std::string_view type, std::vector<std::byte> const& data) {
        append(png, data.size(), 4);
        std::size_t const start = png.size();
        for (char const c : type) png.push_back(static_cast<std::byte>(c));
        png.insert(png.end(), data.begin(), data.end());
        append(png, crc32(0, reinterpret_cast<Bytef const*>(&png[start]), static_cast<uInt>(png.size() - start)), 4);
    };
    append(png, 0x89504E470D0A1A0A, 8);
    std::vector<std::byte> header, rows;
    append(header, image.extent.width, 4);
    append(header, image.extent.height, 4);
    append(header, 0x1006000000, 5); // 16 bits, RGBA, the usual compression and filters, not interlaced
    for (std::uint32_t y = 0; y < image.extent.height; ++y) {
        append(rows, 0, 1); // no filter
        for (std::uint32_t i = 0; i < 4 * image.extent.width; ++i) append(rows, image.at(0, y)[i], 2);
    }
    uLongf length = compressBound(rows.size());
    std::vector<std::byte> compressed(length);
    compress(reinterpret_cast<Bytef*>(compressed.data()), &length, reinterpret_cast<Bytef const*>(rows.data()), rows.size());
    compressed.resize(length);
    add_chunk("IHDR", header);
    add_chunk("IDAT", compressed);
    add_chunk("IEND", {});
    return png;
}

/// Each texel has `first` and `step` times its column in all colours, and is opaque.
inline DeepImage deep_gradient(Extent extent, int first, int step) {
    DeepImage image(extent);
    for (std::uint32_t y = 0; y < extent.height; ++y) {
        for (std::uint32_t x = 0; x < extent.width; ++x) {
            for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<std::uint16_t>(first + step * static_cast<int>(x));
            image.at(x, y)[3] = 65535;
        }
    }
    return image;
}

} // namespace alpenglow::test
