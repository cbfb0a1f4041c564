#include "render/passes/show.h"

#include "core/error.h"
#include "interop/display.h"
#include "render/frame_constants.h"

#include <embedded_shaders.h>
#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

std::vector<std::string> shown_names(FrameGraph const& graph) {
    std::vector<std::string> names{SHOW_CASCADES};
    for (FrameGraph::Image const& image : graph.images()) {
        if (image.scale != ShowScale::encoded && image.scale != ShowScale::number) names.push_back(image.name);
    }
    return names;
}

void add_show(FrameGraph& graph, Settings const& settings, ImageId exposure, ImageId picture) {
    std::vector<std::string> const names = shown_names(graph);
    if (std::ranges::find(names, settings.show) == names.end()) {
        throw Error(ErrorKind::wrong_use, "there is no image '" + settings.show + "' in the frame", "show",
                    fmt::format("choose one of: {}", fmt::join(names, ", ")));
    }
    // The picture of the cascades is made by the lighting pass itself.
    ImageId const shown = graph.find(settings.show == SHOW_CASCADES ? "radiance" : settings.show);
    FrameGraph::Image const& image = graph.images()[shown.index];
    shader::ShowPush const push{static_cast<int>(image.scale), static_cast<int>(image.shape.layers),
                                static_cast<float>(NEAR_PLANE)};
    graph.add(ComputePass{"show",
                          shaders::show_comp,
                          {sampled_array(SHOW_IMAGE_SLOT, shown, NEAREST_CLAMP), stored(SHOW_PICTURE_SLOT, picture),
                           sampled(SHOW_EXPOSURE_SLOT, exposure, NEAREST_CLAMP)},
                          graph.shape(picture).extent,
                          bytes_of(push),
                          curve_index(settings.curve)});
}

} // namespace alpenglow
