#pragma once

#include "core/settings.h"
#include "render/frame_graph.h"

namespace alpenglow {

/// What `settings.show` may name: the images of the frame that a picture can be made of.
std::vector<std::string> shown_names(FrameGraph const& graph);

/// Shows the image that `settings.show` names in place of the result. Throws Error(wrong_use) with the names there are.
void add_show(FrameGraph& graph, Settings const& settings, ImageId exposure, ImageId picture);

} // namespace alpenglow
