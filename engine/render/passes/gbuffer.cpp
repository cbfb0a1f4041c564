#include "render/passes/gbuffer.h"

#include "interop/gbuffer.h"

#include <embedded_shaders.h>

namespace alpenglow {

namespace {

GBuffer make_images(FrameGraph& graph, Extent extent) {
    return {graph.add_image("albedo", {ALBEDO_FORMAT, extent}, ShowScale::unit),
            graph.add_image("normal", {NORMAL_FORMAT, extent}, ShowScale::normal),
            graph.add_image("material", {MATERIAL_FORMAT, extent}, ShowScale::unit),
            graph.add_image("emission", {EMISSION_FORMAT, extent}, ShowScale::radiance),
            graph.add_image("depth", {VK_FORMAT_D32_SFLOAT, extent}, ShowScale::depth)};
}

GBuffer find_images(FrameGraph const& graph) {
    return {graph.find("albedo"), graph.find("normal"), graph.find("material"), graph.find("emission"),
            graph.find("depth")};
}

RasterState planet_pipeline() { return {.vertex = shaders::fullscreen_vert, .fragment = shaders::planet_frag}; }

void draw_scene(DrawContext& context, FrameInputs const& in) {
    double const aspect = static_cast<double>(in.extent.width) / in.extent.height;
    std::vector<std::uint32_t> visible;
    for (std::uint32_t i = 0; i < in.scene->items().size(); ++i) {
        if (in_view(in.world.camera, aspect, in.scene->items()[i].bounds)) visible.push_back(i);
    }
    in.scene->draw(context, visible, in.world.camera.position, PROJECTION_VIEW, GpuScene::Which::all, true);
}

void draw_planet(DrawContext& context) {
    vkCmdSetCullMode(context.commands(), VK_CULL_MODE_NONE);
    vkCmdDraw(context.commands(), 3, 1, 0, 0);
}

} // namespace

GBuffer add_gbuffer(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, int sample) {
    GBuffer const gbuffer = sample == 0 ? make_images(graph, in.extent) : find_images(graph);
    RasterPass pass;
    pass.name = "gbuffer";
    pass.colors = {gbuffer.albedo, gbuffer.normal, gbuffer.material, gbuffer.emission};
    pass.clear_colors = true;
    pass.depth = gbuffer.depth;
    pass.clear_depth = 0.0f;
    pass.slots = {constants(FRAME_SLOT, frame)};
    if (in.scene) pass.pipelines.push_back(in.scene->surface_pipeline());
    if (!in.world.studio) pass.pipelines.push_back(planet_pipeline());
    pass.draw = [&in](DrawContext& context) {
        std::size_t pipeline = 0;
        if (in.scene) context.use(pipeline++), draw_scene(context, in);
        if (!in.world.studio) context.use(pipeline), draw_planet(context);
    };
    graph.add(std::move(pass));
    return gbuffer;
}

} // namespace alpenglow
