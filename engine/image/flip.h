#pragma once

#include "image/image.h"

#include <vector>

namespace alpenglow {

/// A screen of 3840 pixels, 0.7 m wide, seen from 0.7 m: the paper's default.
constexpr double DEFAULT_PIXELS_PER_DEGREE = 67.0206;

struct FlipResult {
    Extent extent;
    std::vector<float> error; ///< 0 (no difference seen) to 1 for each pixel, row by row from the top left
    double mean = 0, median = 0, largest = 0;
};

/// LDR-FLIP: how different two sRGB pictures look when one flips between them. Alpha is left out. Andersson, Nilsson,
/// Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
/// Throws Error(bad_input) where the extents differ or there are no pixels.
FlipResult compute_flip(ByteImage const& reference, ByteImage const& test,
                        double pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE);

} // namespace alpenglow
