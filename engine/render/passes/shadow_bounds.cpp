#include "render/passes/shadow_bounds.h"

#include "interop/shadow_bounds.h"

#include <bit>
#include <embedded_shaders.h>

namespace alpenglow {

namespace {

ImageId add_shadow_blocks(FrameGraph& graph, ImageId cascades) {
    ImageShape const shadow = graph.shape(cascades);
    std::uint32_t const side = std::bit_ceil((shadow.extent.width + SHADOW_BLOCK - 1) / SHADOW_BLOCK);
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

ImageId add_shadow_bounds(FrameGraph& graph, ImageId cascades) {
    ImageId const blocks = add_shadow_blocks(graph, cascades);
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
