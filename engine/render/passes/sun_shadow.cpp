#include "render/passes/sun_shadow.h"

#include "interop/gbuffer.h"

namespace alpenglow {

namespace {

// Slope bias of the casters [texels of depth for each unit of slope]; the rest is the receivers' normal offset.
constexpr float CASTER_SLOPE_BIAS = 1.0f;

std::vector<std::uint32_t> casters(FrameInputs const& in, CascadeFit const& cascade) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < in.scene->items().size(); ++i) {
        if (touches(cascade, in.shadow.light_from_world, in.scene->items()[i].bounds)) result.push_back(i);
    }
    return result;
}

void draw_casters(DrawContext& context, FrameInputs const& in, std::size_t cascade) {
    std::vector<std::uint32_t> const items = casters(in, in.shadow.cascades[cascade]);
    int const projection = PROJECTION_CASCADE + static_cast<int>(cascade);
    in.scene->draw_depth(context, items, in.world.camera.position, projection);
}

} // namespace

ImageId add_sun_shadow(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    bool const any = in.scene && !in.shadow.cascades.empty() && (in.settings.shadows || in.settings.shafts != "off");
    auto const side = any ? static_cast<std::uint32_t>(in.settings.cascade_size) : 1u;
    auto const layers = any ? static_cast<std::uint32_t>(in.shadow.cascades.size()) : 1u;
    ImageId const cascades = graph.add_image("shadow", {VK_FORMAT_D32_SFLOAT, {side, side}, layers}, ShowScale::shadow);
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        RasterPass pass{"sun_shadow", {}, false, cascades, 1.0f, layer, {constants(FRAME_SLOT, frame)},
                        {},           [](DrawContext&) {}};
        if (any) {
            pass.pipelines = in.scene->depth_pipelines(CASTER_SLOPE_BIAS);
            pass.draw = [&in, layer](DrawContext& context) { draw_casters(context, in, layer); };
        }
        graph.add(std::move(pass));
    }
    return cascades;
}

} // namespace alpenglow
