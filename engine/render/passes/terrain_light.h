#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The map of the light from all round on the scene's terrain, made anew where it is stale: interop/terrain_light.h.
TerrainLight add_terrain_light(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, SkyTables const& sky,
                               ImageId ceiling);

} // namespace alpenglow
