#include "render/passes/shadow_bounds.h"

#include "interop/shadow_bounds.h"

#include <bit>
#include <embedded_shaders.h>

namespace alpenglow {

ImageId add_shadow_bounds(FrameGraph& graph, ImageId cascades) {
    ImageShape const shadow = graph.shape(cascades);
    std::uint32_t const side = std::bit_ceil((shadow.extent.width + SHADOW_BLOCK - 1) / SHADOW_BLOCK);
    Extent const size{side + (side + 1) / 2, side * shadow.layers};
    ImageId const bounds = graph.add_image("shadow_bounds", {VK_FORMAT_R32G32_SFLOAT, size}, ShowScale::unit);
    for (int level = 0; side >> level > 0; ++level) {
        graph.add(ComputePass{"shadow_bounds",
                              shaders::shadow_bounds_comp,
                              {sampled_array(SHADOW_BOUNDS_CASCADES_SLOT, cascades, NEAREST_CLAMP),
                               level == 0 ? stored(SHADOW_BOUNDS_IMAGE_SLOT, bounds)
                                          : updated(SHADOW_BOUNDS_IMAGE_SLOT, bounds)},
                              {side >> level, (side >> level) * shadow.layers},
                              bytes_of(shader::ShadowBoundsPush{static_cast<int>(side), level})});
    }
    return bounds;
}

} // namespace alpenglow
