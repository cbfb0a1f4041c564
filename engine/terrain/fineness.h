#pragma once

#include "terrain/terrain.h"

#include <vector>

namespace alpenglow {

/// How far apart the terrain's vertices should stand at a place: 5 m at the fine places, about 40 m 3 km from them, 190 m from
/// 15 km on. Detail smaller than the vertices can show is left out of the relief, by place and not by tile, so that tiles agree.
class Fineness {
public:
    static constexpr double FINEST = 6, COARSEST = 190; ///< [m]

    explicit Fineness(std::vector<FinePlace> places) : places_(std::move(places)) {}

    /// [m] within a square of half side `half` around a point, at its best.
    double spacing(double east, double north, double half = 0) const;

private:
    std::vector<FinePlace> places_;
};

} // namespace alpenglow
