#pragma once

#include "render/frame_graph.h"

namespace alpenglow {

/// Fills a table of optical depth to the top of the air, as shaders/atmosphere/transmittance.glsl reads it.
void add_transmittance(FrameGraph& graph, ConstantsId frame, ImageId table);

} // namespace alpenglow
