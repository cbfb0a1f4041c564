#pragma once

#include "image/image.h"

namespace alpenglow {

/// Throws Error(bad_input), which names both.
void require_same_extent(Extent a, Extent b);

/// How far two 8-bit pictures are apart; alpha is left out. In steps of 1/255.
struct ByteDifference {
    int largest = 0;            ///< over all pixels and colour channels
    double mean = 0;            ///< mean absolute difference of the colour channels
    double share_above = 0;     ///< share of pixels, 0..1, where some channel differs by more than the tolerance
    std::uint32_t x = 0, y = 0; ///< the first pixel with the largest difference
};

/// Throws Error(bad_input) where the extents differ; so do the other functions here.
ByteDifference compare(ByteImage const& a, ByteImage const& b, int tolerance);

/// How far two radiance pictures are apart, over the colour channels. A value that is not finite in either makes
/// `largest`, `mean` and `rmse` infinite, so that no tolerance lets it pass.
struct FloatDifference {
    double largest = 0;
    double mean = 0;   ///< mean absolute difference
    double rmse = 0;   ///< root of the mean square difference
    double mean_a = 0; ///< mean of a's channels, for relative measures
};

FloatDifference compare(FloatImage const& a, FloatImage const& b);

/// Whether red, green and blue of a pixel are neither NaN nor infinite.
bool is_finite_color(float const* rgb);

/// The number of pixels with a colour channel or an alpha that is NaN or infinite.
std::size_t count_non_finite(FloatImage const& image);

/// |a - b| times `gain`, clamped to 255, opaque: black where the pictures are the same.
ByteImage difference_picture(ByteImage const& a, ByteImage const& b, double gain = 8);

/// a, b and their difference picture side by side, each separated by 4 grey pixels.
ByteImage side_by_side(ByteImage const& a, ByteImage const& b, double gain = 8);

} // namespace alpenglow
