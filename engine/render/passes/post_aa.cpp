#include "render/passes/post_aa.h"

#include "interop/display.h"

#include <embedded_shaders.h>

namespace alpenglow {

void add_post_aa(FrameGraph& graph, ImageId encoded, ImageId picture) {
    graph.add(ComputePass{"post_aa",
                          shaders::post_aa_comp,
                          {sampled(POST_AA_PICTURE_SLOT, encoded), stored(POST_AA_RESULT_SLOT, picture)},
                          graph.shape(picture).extent});
}

} // namespace alpenglow
