#pragma once

#include "image/image.h"

#include <optional>
#include <span>
#include <vector>

namespace alpenglow {

/// For each pixel, row by row from the top left, whether the luminance of the two pictures differs by more than
/// `share` of the reference's. A pixel with a colour that is not finite in either picture counts. Throws
/// Error(bad_input) where the extents differ.
std::vector<bool> where_apart(FloatImage const& test, FloatImage const& reference, double share);

/// The share of pixels that a mask holds, 0 to 1; 0 for one without pixels.
double share_of(std::vector<bool> const& mask);

/// The mean of the values of those pixels that the mask holds; empty where it holds none. As many values as pixels.
std::optional<double> masked_mean(std::span<float const> values, std::vector<bool> const& mask);

} // namespace alpenglow
