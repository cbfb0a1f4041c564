#pragma once

#include "render/frame.h"

namespace alpenglow {

/// Least and greatest depths of the blocks of each cascade, by which rays skip what is lit or dark as a whole.
ImageId add_shadow_bounds(FrameGraph& graph, ImageId cascades);

} // namespace alpenglow
