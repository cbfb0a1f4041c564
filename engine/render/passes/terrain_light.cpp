#include "render/passes/terrain_light.h"

#include "interop/terrain_light.h"

#include <embedded_shaders.h>

#include <numeric>

namespace alpenglow {

namespace {

struct Above {
    ImageId albedo, normal, depth;
};

Above import_above(FrameGraph& graph, TerrainMaps const& maps) {
    bool const there = !maps.scene_is_new;
    return {graph.import(maps.albedo, "terrain_albedo", ShowScale::unit, there),
            graph.import(maps.normal, "terrain_normal", ShowScale::normal, there),
            graph.import(maps.depth, "terrain_depth", ShowScale::shadow, there)};
}

void draw_above(DrawContext& context, FrameInputs const& in) {
    context.use(0);
    std::vector<std::uint32_t> items(in.scene->items().size());
    std::iota(items.begin(), items.end(), 0u);
    in.scene->draw(context, items, in.terrain.fit().origin, PROJECTION_VIEW, GpuScene::Which::all, true);
}

void add_above(FrameGraph& graph, FrameInputs const& in, Above const& above) {
    Extent const extent = graph.shape(above.depth).extent;
    shader::FrameConstants from_above = in.constants.front();
    from_above.clip_from_relative[PROJECTION_VIEW] = terrain_clip(in.terrain.fit());
    from_above.texture_bias = 0;
    RasterPass pass;
    pass.name = "terrain_above";
    pass.colors = {above.albedo, above.normal,
                   graph.add_image("terrain_material", {MATERIAL_FORMAT, extent}, ShowScale::unit),
                   graph.add_image("terrain_emission", {EMISSION_FORMAT, extent}, ShowScale::radiance)};
    pass.clear_colors = true;
    pass.depth = above.depth;
    pass.clear_depth = 0.0f;
    pass.slots = {constants(FRAME_SLOT, graph.add_constants(from_above))};
    pass.pipelines = {in.scene->surface_pipeline()};
    pass.draw = [&in](DrawContext& context) { draw_above(context, in); };
    graph.add(std::move(pass));
}

/// Radiance of the sky around the terrain, by direction and altitude.
ImageId add_sky(FrameGraph& graph, ConstantsId frame, SkyTables const& tables) {
    Extent const extent{TERRAIN_AZIMUTHS * TERRAIN_BANDS, TERRAIN_ALTITUDES}, all{extent.width, TERRAIN_SHADES * extent.height};
    ImageId const sky = graph.add_image("terrain_sky", {VK_FORMAT_R32G32B32A32_SFLOAT, all}, ShowScale::radiance);
    graph.add(ComputePass{"terrain_sky",
                          shaders::terrain_sky_comp,
                          {constants(FRAME_SLOT, frame), sampled(TERRAIN_SKY_SUNLIGHT_SLOT, tables.sunlight),
                           sampled(TERRAIN_SKY_ORDERS_SLOT, tables.orders), stored(TERRAIN_SKY_RESULT_SLOT, sky)},
                          extent});
    return sky;
}

/// The terrain itself: radiance and height, and its normals.
struct Glow {
    ImageId radiance, facing;
};

Glow add_glow(FrameGraph& graph, ConstantsId frame, SkyTables const& tables, Above const& above, ImageId ceiling) {
    Extent const extent = graph.shape(above.depth).extent;
    Glow const glow{
        graph.add_image("terrain_glow", {VK_FORMAT_R32G32B32A32_SFLOAT, extent}, ShowScale::radiance),
        graph.add_image("terrain_facing", {VK_FORMAT_R16G16B16A16_SFLOAT, extent}, ShowScale::number)};
    graph.add(ComputePass{"terrain_glow",
                          shaders::terrain_glow_comp,
                          {constants(FRAME_SLOT, frame), sampled(TERRAIN_GLOW_SUNLIGHT_SLOT, tables.sunlight),
                           sampled(TERRAIN_GLOW_ORDERS_SLOT, tables.orders),
                           sampled(TERRAIN_GLOW_ALBEDO_SLOT, above.albedo, NEAREST_CLAMP),
                           sampled(TERRAIN_GLOW_NORMAL_SLOT, above.normal, NEAREST_CLAMP),
                           sampled(TERRAIN_GLOW_DEPTH_SLOT, above.depth, NEAREST_CLAMP),
                           sampled(TERRAIN_GLOW_CEILING_SLOT, ceiling), stored(TERRAIN_GLOW_RESULT_SLOT, glow.radiance),
                           stored(TERRAIN_GLOW_FACING_SLOT, glow.facing)},
                          extent});
    return glow;
}

} // namespace

TerrainLight add_terrain_light(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, SkyTables const& sky,
                               ImageId ceiling) {
    TerrainMaps const& maps = in.terrain;
    bool const there = !maps.light_is_new;
    TerrainLight const light{graph.import(maps.light, "terrain_light", ShowScale::number, there),
                             graph.import(maps.air, "terrain_air", ShowScale::number, there)};
    if (!maps.light_is_new) return light;
    Above const above = import_above(graph, maps);
    if (maps.scene_is_new) add_above(graph, in, above);
    Glow const glow = add_glow(graph, frame, sky, above, ceiling);
    graph.add(ComputePass{"terrain_light",
                          shaders::terrain_light_comp,
                          {constants(FRAME_SLOT, frame), sampled(TERRAIN_LIGHT_SKY_SLOT, add_sky(graph, frame, sky)),
                           sampled(TERRAIN_LIGHT_GLOW_SLOT, glow.radiance, NEAREST_CLAMP),
                           sampled(TERRAIN_LIGHT_FACING_SLOT, glow.facing, NEAREST_CLAMP),
                           sampled(TERRAIN_LIGHT_CEILING_SLOT, ceiling),
                           stored(TERRAIN_LIGHT_RESULT_SLOT, light.surfaces)},
                          graph.shape(above.depth).extent});
    std::uint32_t const coarse = graph.shape(light.air).extent.width;
    graph.add(ComputePass{"terrain_air",
                          shaders::terrain_air_comp,
                          {sampled(TERRAIN_AIR_LIGHT_SLOT, light.surfaces), stored(TERRAIN_AIR_RESULT_SLOT, light.air)},
                          {coarse, coarse}});
    return light;
}

} // namespace alpenglow
