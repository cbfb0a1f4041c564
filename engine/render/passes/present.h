#pragma once

#include "render/frame_graph.h"

namespace alpenglow {

/// Puts the picture on the whole of `window`, an image of any size; `decode`: the window encodes what is written as
/// sRGB.
void add_present(FrameGraph& graph, ImageId picture, ImageId window, bool decode);

} // namespace alpenglow
