#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// What the display pass starts from.
enum class DisplaySource {
    radiance, ///< linear
    toned,    ///< behind exposure and curve
};

/// To display-ready 8 bits: exposure and curve where they are still to come, sRGB, dither; into `picture`.
void add_display_to(FrameGraph& graph, ImageId image, DisplaySource source, Settings const& settings, ImageId picture);
/// The same into an image of the frame.
ImageId add_display(FrameGraph& graph, ImageId image, DisplaySource source, Settings const& settings);

} // namespace alpenglow
