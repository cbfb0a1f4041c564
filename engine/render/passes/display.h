#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// Radiance to display-ready 8 bits: exposure, curve, sRGB, dither; into `picture`.
void add_display_to(FrameGraph& graph, ImageId radiance, Settings const& settings, ImageId picture);
/// The same into an image of the frame.
ImageId add_display(FrameGraph& graph, ImageId radiance, Settings const& settings);

} // namespace alpenglow
