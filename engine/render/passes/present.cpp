#include "render/passes/present.h"

#include "interop/present.h"

#include <embedded_shaders.h>

namespace alpenglow {

void add_present(FrameGraph& graph, ImageId picture, ImageId window, bool decode) {
    RasterPass pass;
    pass.name = "present";
    pass.colors = {window};
    pass.clear_colors = true;
    pass.slots = {sampled(PRESENT_PICTURE_SLOT, picture)};
    pass.pipelines = {RasterState{.vertex = shaders::fullscreen_vert, .fragment = shaders::present_frag}};
    pass.draw = [decode](DrawContext& context) {
        context.use(0);
        context.push(bytes_of(shader::PresentPush{decode}));
        vkCmdDraw(context.commands(), 3, 1, 0, 0);
    };
    graph.add(std::move(pass));
}

} // namespace alpenglow
