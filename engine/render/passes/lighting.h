#pragma once

#include "render/frame.h"

namespace alpenglow {

/// Radiance of each pixel, relative to the sun's irradiance: the surface under sun and sky, and the air in front of it.
ImageId add_lighting(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, GBuffer const& gbuffer,
                     SunShadow const& shadow, AirTables const& air, int sample);

} // namespace alpenglow
