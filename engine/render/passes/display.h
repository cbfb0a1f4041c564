#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// From what is seen, linear and behind the tone curve, to display-ready 8 bits: sRGB and dither; into `picture`.
void add_display_to(FrameGraph& graph, ImageId toned, Settings const& settings, ImageId picture);
/// The same into an image of the frame.
ImageId add_display(FrameGraph& graph, ImageId toned, Settings const& settings);

} // namespace alpenglow
