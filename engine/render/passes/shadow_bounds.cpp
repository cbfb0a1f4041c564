#include "render/passes/shadow_bounds.h"

#include "interop/shadow_bounds.h"
#include "render/models/model.h"

#include <bit>
#include <embedded_shaders.h>

namespace alpenglow {

namespace {

bool shafts_are_looked_for(FrameInputs const& in) {
    return in.air.model.finds_shafts && (in.constants.front().flags & FRAME_SHAFTS) != 0;
}

/// `side`: blocks of a cascade each way, a power of two.
ImageId add_shadow_blocks(FrameGraph& graph, ImageId cascades, std::uint32_t side) {
    ImageShape const shadow = graph.shape(cascades);
    Extent const size{static_cast<std::uint32_t>(shader::bounds_width(static_cast<int>(side))), side * shadow.layers};
    ImageId const blocks = graph.add_image("shadow_blocks", {VK_FORMAT_R32G32_SFLOAT, size}, ShowScale::unit);
    for (int level = 0; side >> level > 0; ++level) {
        graph.add(ComputePass{"shadow_blocks",
                              shaders::shadow_blocks_comp,
                              {sampled_array(SHADOW_BLOCKS_CASCADES_SLOT, cascades, NEAREST_CLAMP),
                               level == 0 ? stored(SHADOW_BLOCKS_IMAGE_SLOT, blocks)
                                          : updated(SHADOW_BLOCKS_IMAGE_SLOT, blocks)},
                              {side >> level, (side >> level) * shadow.layers},
                              bytes_of(shader::ShadowBlocksPush{static_cast<int>(side), level})});
    }
    return blocks;
}

} // namespace

ImageId add_shadow_bounds(FrameGraph& graph, FrameInputs const& in, ImageId cascades) {
    std::uint32_t const blocks_each_way = (graph.shape(cascades).extent.width + SHADOW_BLOCK - 1) / SHADOW_BLOCK;
    ImageId const blocks = add_shadow_blocks(graph, cascades, shafts_are_looked_for(in) ? std::bit_ceil(blocks_each_way) : 1);
    ImageShape const shape = graph.shape(blocks);
    ImageId const bounds = graph.add_image("shadow_bounds", shape, ShowScale::unit);
    graph.add(ComputePass{"shadow_bounds",
                          shaders::shadow_bounds_comp,
                          {sampled(SHADOW_BOUNDS_BLOCKS_SLOT, blocks, NEAREST_CLAMP),
                           stored(SHADOW_BOUNDS_IMAGE_SLOT, bounds)},
                          shape.extent});
    return bounds;
}

} // namespace alpenglow
