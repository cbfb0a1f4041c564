#pragma once

#include <cstddef>
#include <vector>

namespace alpenglow {

/// Altitude and its slope along the map's axes.
struct HeightSample {
    double altitude = 0;        ///< [m]
    double east = 0, north = 0; ///< d altitude / d east, d altitude / d north
};

/// A square of altitudes [m] on the map plane, centred on the origin; rows run from south to north, nodes from west to
/// east.
class HeightField {
public:
    HeightField(int cells, double side) : nodes_(cells + 1), side_(side), altitude_(std::size_t(nodes_) * nodes_) {}

    int nodes() const { return nodes_; }                                            ///< along a side
    double side() const { return side_; }                                           ///< [m]
    double cell() const { return side_ / (nodes_ - 1); }                            ///< [m]
    double position(int i) const { return side_ * i / (nodes_ - 1) - 0.5 * side_; } ///< [m] east or north of a node
    std::size_t index(int i, int j) const { return std::size_t(j) * nodes_ + i; }
    float& at(int i, int j) { return altitude_[index(i, j)]; }
    float at(int i, int j) const { return altitude_[index(i, j)]; }
    std::vector<float>& altitudes() { return altitude_; }
    std::vector<float> const& altitudes() const { return altitude_; }

    /// Catmull-Rom: through the nodes, slope continuous. Beyond the border the border's altitude goes on.
    HeightSample sample(double east, double north) const;
    /// Bilinear: rougher, and several times faster.
    double rough_altitude(double east, double north) const;

private:
    int nodes_;
    double side_;
    std::vector<float> altitude_;
};

} // namespace alpenglow
