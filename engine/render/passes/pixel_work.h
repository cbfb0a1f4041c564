#pragma once

#include "render/frame.h"

namespace alpenglow {

/// Lists the pixels that show a surface and those that show the sky, for passes that have to do with the ones or the others:
/// interop/pixel_work.h.
WorkListId add_pixel_work(FrameGraph& graph, ImageId depth);

} // namespace alpenglow
