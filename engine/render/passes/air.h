#pragma once

#include "render/frame.h"

namespace alpenglow {

/// What the air in front of each pixel adds and lets through. A texel each without air.
AirLayer add_air(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, ImageId depth, SunShadow const& shadow,
                 AirTables const& tables, int sample);

} // namespace alpenglow
