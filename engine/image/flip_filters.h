#pragma once

#include "core/extent.h"

#include <array>
#include <vector>

/// The filters of FLIP: what the eye resolves at a distance, and where it sees edges and points. Sections and tables
/// are of Andersson et al. 2020, as in image/flip_color.h.
namespace alpenglow::flip {

using Kernel = std::vector<float>; ///< odd length, its centre in the middle

/// One channel of a picture, row by row.
struct Plane {
    Extent extent;
    std::vector<float> values;

    explicit Plane(Extent e = {}) : extent(e), values(e.pixels()) {}
};

/// Both along rows and columns; beyond the edges the last pixel is repeated.
Plane convolve(Plane const& plane, Kernel const& across, Kernel const& down);

/// A part of a filter, the same across and down.
struct Lobe {
    float weight;
    Kernel kernel;
};
/// Contrast sensitivity of one channel: the sum of its lobes, which lets a uniform channel through as it is.
using Sensitivity = std::vector<Lobe>;

/// All filters for a screen that shows so many pixels in a degree of sight.
struct Filters {
    std::array<Sensitivity, 3> sensitivity; ///< achromatic, red-green, blue-yellow (section 4.1.1, Table 1)
    Kernel smooth, edge, point;             ///< a Gaussian of sum 1 and its derivatives (section 4.2)

    explicit Filters(double pixels_per_degree);
};

/// The channel as the eye resolves it.
Plane resolved(Sensitivity const& sensitivity, Plane const& plane);

/// Magnitude for each pixel.
struct Features {
    Plane edges, points;
};

/// `lightness` 0..1: a full step gives an edge of magnitude 1 where it is steepest.
Features find_features(Filters const& filters, Plane const& lightness);

} // namespace alpenglow::flip
