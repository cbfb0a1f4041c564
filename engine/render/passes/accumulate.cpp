#include "render/passes/accumulate.h"

#include "interop/display.h"

#include <embedded_shaders.h>

namespace alpenglow {

void add_accumulate(FrameGraph& graph, ImageId lit, ImageId mean, int index, int count) {
    Slot const target = index == 0 ? stored(ACCUMULATE_MEAN_SLOT, mean) : updated(ACCUMULATE_MEAN_SLOT, mean);
    graph.add(ComputePass{"accumulate", shaders::accumulate_comp, {sampled(ACCUMULATE_LIT_SLOT, lit, NEAREST_CLAMP), target},
                          graph.shape(lit).extent, bytes_of(shader::AccumulatePush{index, count})});
}

} // namespace alpenglow
