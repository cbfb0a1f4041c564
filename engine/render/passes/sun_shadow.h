#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The scene's depth as the sun sees it, a layer for each cascade. Without a scene one texel that shades nothing.
ImageId add_sun_shadow(FrameGraph& graph, FrameInputs const& in, ConstantsId frame);

} // namespace alpenglow
