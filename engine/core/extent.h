#pragma once

#include <cstddef>
#include <cstdint>

namespace alpenglow {

/// Width and height in pixels.
struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    bool operator==(Extent const&) const = default;
    std::size_t pixels() const { return std::size_t{width} * height; }
};

} // namespace alpenglow
