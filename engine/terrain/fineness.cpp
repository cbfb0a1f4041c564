#include "terrain/fineness.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

double Fineness::spacing(double east, double north, double half) const {
    double spacing = COARSEST;
    for (FinePlace const& place : places_) {
        double const de = std::max(0.0, std::abs(place.east - east) - half),
                     dn = std::max(0.0, std::abs(place.north - north) - half);
        double const beyond = std::max(0.0, std::hypot(de, dn) - place.radius);
        double const near = std::min(FINEST + 0.06 * beyond, 40.0);
        double const middle = std::min(near + std::max(0.0, 0.08 * (beyond - 2000)), 190.0);
        spacing = std::min(spacing, middle + std::max(0.0, 0.02 * (beyond - 15'000)));
    }
    return spacing;
}

} // namespace alpenglow
