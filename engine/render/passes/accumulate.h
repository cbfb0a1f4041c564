#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// Adds supersample `index` of `settings.aa` to the mean radiance and to the mean of what the tone curve makes of it,
/// and gives the latter.
ImageId add_accumulate(FrameGraph& graph, ImageId lit, ImageId mean, ImageId exposure, Settings const& settings,
                       int index);

} // namespace alpenglow
