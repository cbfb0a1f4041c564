#pragma once

#include <vector>

namespace alpenglow {

/// The optical path through an exponential medium around a sphere, up to infinity: for a ray that climbs from radius r
/// with the zenith cosine mu, the integral of exp(-(r(s) - r) / H) ds [m]. Chapman 1931; tabulated from a quadrature,
/// within 1e-8 of its value where `highest` is at most twice `lowest`.
class ChapmanTable {
public:
    /// For radii in [lowest, highest] [m] and mu in [0, 1].
    ChapmanTable(double lowest, double highest, double scale_height);

    double path(double radius, double mu) const;

private:
    int rows_;
    double lowest_, scale_height_, rows_per_metre_;
    std::vector<double> nodes_; ///< path / H * (mu + width), row by row of the radius
};

} // namespace alpenglow
