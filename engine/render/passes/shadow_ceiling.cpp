#include "render/passes/shadow_ceiling.h"

#include <embedded_shaders.h>

#include <numeric>

namespace alpenglow {

namespace {

void draw_from_above(DrawContext& context, FrameInputs const& in) {
    std::vector<std::uint32_t> items(in.scene->items().size());
    std::iota(items.begin(), items.end(), 0u);
    in.scene->draw_depth(context, items, in.ceiling.fit.origin, PROJECTION_VIEW);
}

/// The frame's constants, with the scene seen from above in place of the camera's view.
ConstantsId constants_from_above(FrameGraph& graph, FrameInputs const& in) {
    shader::FrameConstants above = in.constants.front();
    above.clip_from_relative[PROJECTION_VIEW] = ceiling_clip(in.ceiling.fit);
    return graph.add_constants(above);
}

} // namespace

ImageId add_shadow_ceiling(FrameGraph& graph, FrameInputs const& in) {
    ImageId const map = graph.import(in.ceiling.map, "shadow_ceiling", ShowScale::number, !in.ceiling.is_new);
    if (!in.ceiling.is_new) return map;
    Extent const size = graph.shape(map).extent;
    ImageId const heights = graph.add_image("terrain_height", {VK_FORMAT_D32_SFLOAT, size}, ShowScale::shadow);
    ConstantsId const above = constants_from_above(graph, in);
    graph.add(RasterPass{"terrain_height", {}, false, heights, 1.0f, 0, {constants(FRAME_SLOT, above)},
                         in.scene->depth_pipelines(0), [&in](DrawContext& context) { draw_from_above(context, in); }});
    constexpr std::uint32_t PER_GROUP = CEILING_COLUMNS / WORKGROUP_SIZE;
    graph.add(ComputePass{"shadow_ceiling",
                          shaders::shadow_ceiling_comp,
                          {sampled(CEILING_HEIGHT_SLOT, heights, NEAREST_CLAMP), stored(CEILING_MAP_SLOT, map)},
                          {(size.width + PER_GROUP - 1) / PER_GROUP, 1},
                          bytes_of(ceiling_push(in.ceiling.fit))});
    return map;
}

} // namespace alpenglow
