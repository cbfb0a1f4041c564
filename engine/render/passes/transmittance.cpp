#include "render/passes/transmittance.h"

#include "interop/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

void add_transmittance(FrameGraph& graph, ConstantsId frame, ImageId table) {
    graph.add(ComputePass{"transmittance",
                          shaders::transmittance_comp,
                          {constants(TRANSMITTANCE_FRAME_SLOT, frame), stored(TRANSMITTANCE_TABLE_SLOT, table)},
                          graph.shape(table).extent});
}

} // namespace alpenglow
