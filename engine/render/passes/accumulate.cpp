#include "render/passes/accumulate.h"

#include "interop/display.h"
#include "render/frame_constants.h"

#include <embedded_shaders.h>

namespace alpenglow {

ImageId add_accumulate(FrameGraph& graph, ImageId lit, ImageId mean, ImageId exposure, Settings const& settings,
                       int index) {
    ImageId const toned =
        index == 0 ? graph.add_image("toned", graph.shape(mean), ShowScale::unit) : graph.find("toned");
    auto const target = [&](std::uint32_t slot, ImageId image) {
        return index == 0 ? stored(slot, image) : updated(slot, image);
    };
    shader::AccumulatePush const push{index, settings.aa};
    graph.add(ComputePass{"accumulate",
                          shaders::accumulate_comp,
                          {sampled(ACCUMULATE_LIT_SLOT, lit, NEAREST_CLAMP), target(ACCUMULATE_MEAN_SLOT, mean),
                           target(ACCUMULATE_TONED_SLOT, toned),
                           sampled(ACCUMULATE_EXPOSURE_SLOT, exposure, NEAREST_CLAMP)},
                          graph.shape(lit).extent,
                          bytes_of(push),
                          curve_index(settings.curve)});
    return toned;
}

} // namespace alpenglow
