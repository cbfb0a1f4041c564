#pragma once

#include "render/frame_graph.h"

#include <string>

namespace alpenglow {

/// docs/frame.md: the passes of a frame in order, with what each reads and writes, and its images, in Markdown.
std::string frame_document(FrameGraph const& graph);

} // namespace alpenglow
