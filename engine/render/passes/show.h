#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// Shows the image that `settings.show` names in place of the result. Throws Error(wrong_use) with the names there are.
void add_show(FrameGraph& graph, Settings const& settings, ImageId picture);

} // namespace alpenglow
