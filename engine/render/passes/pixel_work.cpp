#include "render/passes/pixel_work.h"

#include "interop/pixel_work.h"

#include <embedded_shaders.h>

namespace alpenglow {

WorkListId add_pixel_work(FrameGraph& graph, ImageId depth) {
    Extent const extent = graph.shape(depth).extent;
    Extent const blocks{extent.width, (extent.height + PIXEL_WORK_ROWS - 1) / PIXEL_WORK_ROWS};
    WorkListId const list = graph.add_work_list("pixel_work", WORK_KINDS * blocks.pixels());
    graph.add(ComputePass{"pixel_work",
                          shaders::pixel_work_comp,
                          {sampled(PIXEL_WORK_DEPTH_SLOT, depth, NEAREST_CLAMP), fills(PIXEL_WORK_LIST_SLOT, list)},
                          blocks});
    return list;
}

} // namespace alpenglow
