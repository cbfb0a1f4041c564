#pragma once

#include "image/image.h"

#include <span>
#include <vector>

namespace alpenglow {

/// The levels below a picture of four bytes a texel, each half as wide and high, down to one texel. A texel is the mean
/// of what it covers, in linear light where `srgb`; alpha is always linear. Odd sides are rounded down, and no texel is
/// left out: it counts to two neighbours by its shares. Rounded to nearest. Works on all cores.
std::vector<ByteImage> mip_levels(Extent extent, std::span<std::uint8_t const> rgba, bool srgb);
/// The same for sixteen bits a channel, which must be linear: `srgb` false.
std::vector<DeepImage> mip_levels(Extent extent, std::span<std::uint16_t const> rgba, bool srgb);

} // namespace alpenglow
