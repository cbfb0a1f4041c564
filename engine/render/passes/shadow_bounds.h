#pragma once

#include "render/frame.h"

namespace alpenglow {

/// Least and greatest depths of the blocks of each cascade, by which rays skip what is lit or dark as a whole; of a single block
/// where no ray looks for shafts.
ImageId add_shadow_bounds(FrameGraph& graph, FrameInputs const& in, ImageId cascades);

} // namespace alpenglow
