#pragma once

#include "core/extent.h"

#include <cstdint>
#include <vector>

namespace alpenglow {

/// Linear Rec.709 radiance, four floats a pixel (RGBA), row by row from the top left.
struct FloatImage {
    Extent extent;
    std::vector<float> rgba;

    explicit FloatImage(Extent e = {}) : extent(e), rgba(e.pixels() * 4) {}
    float* at(std::uint32_t x, std::uint32_t y) { return &rgba[(std::size_t{y} * extent.width + x) * 4]; }
    float const* at(std::uint32_t x, std::uint32_t y) const { return &rgba[(std::size_t{y} * extent.width + x) * 4]; }
};

/// sRGB-encoded, four bytes a pixel (RGBA), row by row from the top left.
struct ByteImage {
    Extent extent;
    std::vector<std::uint8_t> rgba;

    explicit ByteImage(Extent e = {}) : extent(e), rgba(e.pixels() * 4) {}
    std::uint8_t* at(std::uint32_t x, std::uint32_t y) { return &rgba[(std::size_t{y} * extent.width + x) * 4]; }
    std::uint8_t const* at(std::uint32_t x, std::uint32_t y) const {
        return &rgba[(std::size_t{y} * extent.width + x) * 4];
    }
};

/// Sixteen bits a channel (RGBA), row by row from the top left; encoded as its file has it.
struct DeepImage {
    Extent extent;
    std::vector<std::uint16_t> rgba;

    explicit DeepImage(Extent e = {}) : extent(e), rgba(e.pixels() * 4) {}
    std::uint16_t* at(std::uint32_t x, std::uint32_t y) { return &rgba[(std::size_t{y} * extent.width + x) * 4]; }
    std::uint16_t const* at(std::uint32_t x, std::uint32_t y) const {
        return &rgba[(std::size_t{y} * extent.width + x) * 4];
    }
};

} // namespace alpenglow
