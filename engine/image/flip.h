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

/// The same for pictures in linear light as a screen shows it: 0 black to 1 white, what is beyond is clamped. Pixels
/// with a colour that is not finite in either picture are black to the filters and have the error 1.
FlipResult compute_flip(FloatImage const& reference, FloatImage const& test,
                        double pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE);

/// Exposures from `start` to `stop` in equal steps, both included.
struct ExposureRange {
    double start = 0, stop = 0; ///< [stops]
    int count = 1;
};

/// What HDR-FLIP looks at: from the exposure at which the picture's largest luminance comes out at 0.85 of the display
/// to the one at which its median does, a picture for each stop and at least two. A median below 2^-23 of the largest
/// counts as that, so that black sky does not ask for exposures without end; a picture without light has the single
/// exposure 0. Pixels that are not finite count as black, and so does what is negative.
ExposureRange flip_exposures(FloatImage const& reference);

struct HdrFlipResult : FlipResult {
    ExposureRange exposures;
};

/// HDR-FLIP of two pictures of radiance: for each pixel the largest LDR-FLIP of those exposures, through the ACES
/// curve. A factor on both pictures changes nothing. Pixels that are not finite as in compute_flip. Andersson, Nilsson,
/// Shirley, Akenine-Möller: "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021. Throws as
/// compute_flip.
HdrFlipResult compute_hdr_flip(FloatImage const& reference, FloatImage const& test,
                               double pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE);

} // namespace alpenglow
