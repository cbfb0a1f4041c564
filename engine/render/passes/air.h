#pragma once

#include "render/frame.h"

namespace alpenglow {

/// What ends the air's rays and shades them.
struct AirObstacles {
    ImageId depth; ///< of the G-buffer
    SunShadow const& shadow;
    ImageId shadow_bounds;
    ImageId terrain_air; ///< light from all round over terrain
};

/// What the air in front of each pixel adds and lets through. A texel each without air.
AirLayer add_air(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, AirObstacles const& obstacles,
                 AirTables const& tables, int sample);

} // namespace alpenglow
