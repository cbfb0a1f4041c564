#pragma once

#include <cstdint>

namespace alpenglow {

/// The plan of the land before the rivers work on it: where the shore is, how fast the rock rises, where the main
/// valley lies. Lengths scale with the side, so that a small terrain is a small island.
class Island {
public:
    Island(std::uint32_t seed, double side) : seed_(seed), side_(side) {}

    /// [m] about the distance inland of the shore; negative in the sea, and everywhere along the rim.
    double inland(double east, double north) const;
    /// Rate at which rock rises, relative: 0 to about 1.
    double uplift(double east, double north) const;
    /// [m] altitude of the sea's bed, given inland() < 0; 75 m or more under the sea at the rim.
    double seabed(double inland) const;
    /// [m] mountains without rivers: what erosion starts from.
    double raw_altitude(double east, double north) const;

private:
    double valley_distance(double east, double north) const;

    std::uint32_t seed_;
    double side_;
};

} // namespace alpenglow
