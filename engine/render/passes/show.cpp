#include "render/passes/show.h"

#include "core/error.h"
#include "interop/display.h"
#include "render/frame_constants.h"

#include <embedded_shaders.h>
#include <cmath>

namespace alpenglow {

void add_show(FrameGraph& graph, Settings const& settings, ImageId picture) {
    // The picture of the cascades is made by the lighting pass itself.
    ImageId const shown = graph.find(settings.show == "cascades" ? "radiance" : settings.show);
    if (!shown || shown == picture) {
        std::string names = "cascades";
        for (FrameGraph::Image const& image : graph.images()) {
            if (image.name != graph.images()[picture.index].name) names += ", " + image.name;
        }
        throw Error(ErrorKind::wrong_use, "there is no image '" + settings.show + "' in the frame", "show",
                    "choose one of: " + names);
    }
    FrameGraph::Image const& image = graph.images()[shown.index];
    shader::ShowPush const push{static_cast<float>(std::exp2(settings.exposure)), curve_index(settings.curve),
                                static_cast<int>(image.scale), static_cast<int>(image.shape.layers),
                                static_cast<float>(NEAR_PLANE)};
    graph.add(ComputePass{"show",
                          shaders::show_comp,
                          {sampled_array(SHOW_IMAGE_SLOT, shown, NEAREST_CLAMP), stored(SHOW_PICTURE_SLOT, picture)},
                          graph.shape(picture).extent,
                          bytes_of(push)});
}

} // namespace alpenglow
