#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// Time since the picture before that adapts the exposure at once.
inline constexpr double ADAPTED_AT_ONCE = -1; // [s]

/// Writes to `state`, one texel that outlives the frame, what radiance is multiplied by before the tone curve: what the
/// settings say, or what the luminance of `lit` asks for, `seconds` after the picture before.
void add_exposure(FrameGraph& graph, ImageId lit, ImageId state, Settings const& settings, double seconds);

} // namespace alpenglow
