#pragma once

#include "render/frame_graph.h"

namespace alpenglow {

/// Adds supersample `index` of `count` to the mean.
void add_accumulate(FrameGraph& graph, ImageId lit, ImageId mean, int index, int count);

} // namespace alpenglow
