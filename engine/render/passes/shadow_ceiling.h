#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The map of the shadow ceiling: made anew where it doesn't hold the frame's, else as it is kept.
ImageId add_shadow_ceiling(FrameGraph& graph, FrameInputs const& in);

} // namespace alpenglow
