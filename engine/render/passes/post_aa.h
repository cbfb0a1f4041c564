#pragma once

#include "render/frame_graph.h"

namespace alpenglow {

/// Smooths the edges of an encoded picture (FXAA).
void add_post_aa(FrameGraph& graph, ImageId encoded, ImageId picture);

} // namespace alpenglow
