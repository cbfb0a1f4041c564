#pragma once

#include "terrain/heightfield.h"

#include <cstdint>
#include <vector>

namespace alpenglow {

/// Where the water of each node goes.
struct Flow {
    std::vector<std::int32_t>
        receiver;                ///< the neighbour of steepest descent; the node itself at an outlet and in a pit
    std::vector<float> distance; ///< [m] to the receiver
    std::vector<std::int32_t> upstream; ///< all nodes, each after its receiver
    std::vector<float> area;            ///< [m²] that drains through the node, its own included
};

/// Routes water over the field; nodes at or under `sea` are outlets. Distances are stretched at random (by `seed`, by
/// 0.8 to 1.4), which hides the grid's eight directions.
Flow route_water(HeightField const& field, float sea, std::uint32_t seed, int threads);

/// Raises each pit until it spills over its lowest rim (Barnes, Lehman and Mulla 2014, "Priority-flood", with a small
/// slope towards the spill).
void fill_pits(HeightField& field, float sea);

} // namespace alpenglow
