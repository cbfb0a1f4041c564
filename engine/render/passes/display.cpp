#include "render/passes/display.h"

#include "interop/display.h"

#include <embedded_shaders.h>

namespace alpenglow {

void add_display_to(FrameGraph& graph, ImageId toned, Settings const& settings, ImageId picture) {
    shader::DisplayPush const push{settings.dither};
    graph.add(ComputePass{"display",
                          shaders::display_comp,
                          {sampled(DISPLAY_SOURCE_SLOT, toned, NEAREST_CLAMP), stored(DISPLAY_PICTURE_SLOT, picture)},
                          graph.shape(picture).extent,
                          bytes_of(push)});
}

ImageId add_display(FrameGraph& graph, ImageId toned, Settings const& settings) {
    ImageId const picture =
        graph.add_image("encoded", {VK_FORMAT_R8G8B8A8_UNORM, graph.shape(toned).extent}, ShowScale::encoded);
    add_display_to(graph, toned, settings, picture);
    return picture;
}

} // namespace alpenglow
