#pragma once

#include "terrain/terrain.h"

#include <vector>

namespace alpenglow {

/// How far apart the terrain's vertices should stand at a place: 6 m at the fine places, 40 m from 600 m beyond them to
/// 2 km, 190 m from 4 km to 15 km, 380 m beyond 25 km. Detail smaller than the vertices can show is left out of the
/// relief, by place and not by tile, so that tiles agree.
class Fineness {
public:
    static constexpr double FINEST = 6, COARSEST = 380; ///< [m]

    explicit Fineness(std::vector<FinePlace> places) : places_(std::move(places)) {}

    std::vector<FinePlace> const& places() const { return places_; }
    /// [m] within a square of half side `half` around a point, at its best.
    double spacing(double east, double north, double half = 0) const;

private:
    std::vector<FinePlace> places_;
};

} // namespace alpenglow
