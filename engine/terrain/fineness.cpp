#include "terrain/fineness.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

double Fineness::spacing(double east, double north, double half) const {
    double spacing = COARSEST;
    for (FinePlace const& place : places_) {
        double const de = std::max(0.0, std::abs(place.east - east) - half), dn = std::max(0.0, std::abs(place.north - north) - half);
        double const beyond = std::max(0.0, std::hypot(de, dn) - place.radius);
        spacing = std::min(spacing, FINEST + 0.0125 * beyond);
    }
    return spacing;
}

} // namespace alpenglow
