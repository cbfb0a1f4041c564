#pragma once

#include "terrain/heightfield.h"
#include "terrain/island.h"

#include <cstdint>
#include <functional>

namespace alpenglow {

struct ErosionOptions {
    std::uint32_t seed = 1;
    double side = 96'000;  ///< [m]
    int resolution = 1024; ///< cells along a side
    double strength = 1;   ///< how long rivers work: 0 not at all, 1 until the mountains keep their height
    int threads = 0;       ///< 0: one for each core
};

/// Rock that rises and rivers that cut it (stream power, solved as in Braun and Willett 2013, with slopes limited to
/// what rock can bear), from a coarse grid to the full one; then gravel that fills the valley floors. Nodes in the sea
/// lie under altitude 0. `step_done(done, all)` is called now and then.
HeightField make_eroded_field(ErosionOptions const& options, std::function<void(int, int)> const& step_done);

} // namespace alpenglow
