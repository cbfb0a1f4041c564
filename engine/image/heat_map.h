#pragma once

#include "image/flip.h"

#include <cstdint>

namespace alpenglow {

/// The colour scale magma, 0xRRGGBB in sRGB, dark at 0 and bright at 1: equal steps look equally far apart. `value` is
/// clamped to 0..1. Of Nathaniel Smith and Stéfan van der Walt, matplotlib, CC0; the scale of FLIP's authors too.
std::uint32_t magma(float value);

/// A picture of FLIP's errors in magma, pixel by pixel from the top left, and below it a bar of the scale with the
/// numbers 0 to 1, as wide as the picture.
ByteImage heat_map(FlipResult const& flip);

} // namespace alpenglow
