#include "render/passes/display.h"

#include "interop/display.h"
#include "render/frame_constants.h"

#include <embedded_shaders.h>
#include <cmath>

namespace alpenglow {

void add_display_to(FrameGraph& graph, ImageId image, DisplaySource source, Settings const& settings, ImageId picture) {
    bool const toned = source == DisplaySource::toned;
    shader::DisplayPush const push{toned ? 1.0f : static_cast<float>(std::exp2(settings.exposure)),
                                   toned ? CURVE_NONE : curve_index(settings.curve), settings.dither};
    graph.add(ComputePass{"display",
                          shaders::display_comp,
                          {sampled(DISPLAY_SOURCE_SLOT, image, NEAREST_CLAMP), stored(DISPLAY_PICTURE_SLOT, picture)},
                          graph.shape(picture).extent,
                          bytes_of(push)});
}

ImageId add_display(FrameGraph& graph, ImageId image, DisplaySource source, Settings const& settings) {
    ImageId const picture =
        graph.add_image("encoded", {VK_FORMAT_R8G8B8A8_UNORM, graph.shape(image).extent}, ShowScale::encoded);
    add_display_to(graph, image, source, settings, picture);
    return picture;
}

} // namespace alpenglow
