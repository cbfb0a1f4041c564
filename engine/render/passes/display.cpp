#include "render/passes/display.h"

#include "interop/display.h"
#include "render/frame_constants.h"

#include <embedded_shaders.h>
#include <cmath>

namespace alpenglow {

void add_display_to(FrameGraph& graph, ImageId radiance, Settings const& settings, ImageId picture) {
    shader::DisplayPush const push{static_cast<float>(std::exp2(settings.exposure)), curve_index(settings.curve), settings.dither};
    graph.add(ComputePass{"display", shaders::display_comp, {sampled(DISPLAY_RADIANCE_SLOT, radiance, NEAREST_CLAMP), stored(DISPLAY_PICTURE_SLOT, picture)},
                          graph.shape(picture).extent, bytes_of(push)});
}

ImageId add_display(FrameGraph& graph, ImageId radiance, Settings const& settings) {
    ImageId const picture = graph.add_image("encoded", {VK_FORMAT_R8G8B8A8_UNORM, graph.shape(radiance).extent}, ShowScale::encoded);
    add_display_to(graph, radiance, settings, picture);
    return picture;
}

} // namespace alpenglow
