#include "render/passes/lighting.h"

#include "interop/lighting.h"
#include "interop/work_list.h"
#include "render/frame_constants.h"
#include "render/models/model.h"

#include <embedded_shaders.h>

#include <cmath>

namespace alpenglow {

namespace {

/// The stars keep their distance from the sun's meridian: they rise and set with the hour, and stand still over the year.
glm::vec2 celestial_turn(glm::dvec3 const& to_sun) {
    double const longitude = std::atan2(to_sun.y, to_sun.x);
    return {std::cos(longitude), std::sin(longitude)};
}

void add_sky(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, LitSurfaces const& surfaces, ImageId lit) {
    graph.add(ComputePass{"sky",
                          shaders::sky_comp,
                          {constants(FRAME_SLOT, frame), sampled(LIGHTING_DEPTH_SLOT, surfaces.gbuffer.depth, NEAREST_CLAMP),
                           sampled(LIGHTING_INSCATTERED_SLOT, surfaces.air.inscattered, NEAREST_CLAMP),
                           sampled(LIGHTING_TRANSMITTANCE_SLOT, surfaces.air.transmittance, NEAREST_CLAMP),
                           works_off(LIGHTING_WORK_SLOT, surfaces.pixels, SKY_WORK), cleared(LIGHTING_LIT_SLOT, lit, 0)},
                          {},
                          bytes_of(shader::SkyPush{celestial_turn(in.world.to_sun)})});
}

} // namespace

ImageId add_lighting(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, LitSurfaces const& surfaces,
                     SunShadow const& shadow, AirTables const& tables, int sample) {
    ImageId const lit = sample == 0
                            ? graph.add_image("lit", {VK_FORMAT_R32G32B32A32_SFLOAT, in.extent}, ShowScale::radiance)
                            : graph.find("lit");
    add_sky(graph, in, frame, surfaces, lit);
    shader::LightingPush const push{in.settings.show == SHOW_CASCADES ? LIGHTING_SHOW_CASCADES : LIGHTING_RESULT};
    GBuffer const& gbuffer = surfaces.gbuffer;
    std::vector<Slot> slots{constants(FRAME_SLOT, frame),
                            sampled(LIGHTING_ALBEDO_SLOT, gbuffer.albedo, NEAREST_CLAMP),
                            sampled(LIGHTING_NORMAL_SLOT, gbuffer.normal, NEAREST_CLAMP),
                            sampled(LIGHTING_MATERIAL_SLOT, gbuffer.material, NEAREST_CLAMP),
                            sampled(LIGHTING_EMISSION_SLOT, gbuffer.emission, NEAREST_CLAMP),
                            sampled(LIGHTING_DEPTH_SLOT, gbuffer.depth, NEAREST_CLAMP),
                            sampled_array(LIGHTING_SHADOW_SLOT, shadow.cascades, SHADOW_COMPARE),
                            sampled(LIGHTING_CEILING_SLOT, shadow.ceiling),
                            sampled(LIGHTING_TERRAIN_SLOT, surfaces.terrain_light),
                            sampled(LIGHTING_OPEN_SLOT, surfaces.open, NEAREST_CLAMP),
                            sampled(LIGHTING_INSCATTERED_SLOT, surfaces.air.inscattered, NEAREST_CLAMP),
                            sampled(LIGHTING_TRANSMITTANCE_SLOT, surfaces.air.transmittance, NEAREST_CLAMP),
                            works_off(LIGHTING_WORK_SLOT, surfaces.pixels, SURFACE_WORK),
                            updated(LIGHTING_LIT_SLOT, lit)};
    slots.insert(slots.end(), tables.slots.begin(), tables.slots.end());
    graph.add(ComputePass{"lighting", in.air.model.lighting, std::move(slots), {}, bytes_of(push)});
    return lit;
}

} // namespace alpenglow
