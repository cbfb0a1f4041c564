#pragma once

#include "render/frame.h"

namespace alpenglow {

struct LitSurfaces {
    GBuffer const& gbuffer;
    ImageId open; ///< the share of the light from all round that reaches them
    AirLayer air; ///< in front of them
    ImageId terrain_light; ///< around them
    WorkListId pixels;     ///< that show them or the sky
};

/// Radiance of each pixel, relative to the sun's irradiance: the surface under sun and sky, and the air in front of it.
ImageId add_lighting(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, LitSurfaces const& surfaces,
                     SunShadow const& shadow, AirTables const& tables, int sample);

} // namespace alpenglow
