#include "render/frame.h"

#include "render/passes/accumulate.h"
#include "render/passes/air.h"
#include "render/passes/air_tables.h"
#include "render/passes/ambient_occlusion.h"
#include "render/passes/display.h"
#include "render/passes/exposure.h"
#include "render/passes/gbuffer.h"
#include "render/passes/lighting.h"
#include "render/passes/pixel_work.h"
#include "render/passes/post_aa.h"
#include "render/passes/shadow_bounds.h"
#include "render/passes/shadow_ceiling.h"
#include "render/passes/show.h"
#include "render/passes/sun_shadow.h"
#include "render/passes/terrain_light.h"

namespace alpenglow {

void build_frame(FrameGraph& graph, FrameInputs const& in) {
    ImageId const mean = graph.import(in.mean, "radiance", ShowScale::radiance, false);
    ImageId const picture = graph.import(in.picture, "picture", ShowScale::encoded, false);
    ImageId const exposure = graph.import(in.exposure, "exposure", ShowScale::number, true);
    ConstantsId frame = graph.add_constants(in.constants.front());
    glm::ivec2 const composition = in.constants.front().atmosphere.content.composition;
    graph.specialize({composition.x, composition.y});

    AirTables const tables = add_air_tables(graph, in, frame);
    SunShadow const shadow{add_sun_shadow(graph, in, frame), add_shadow_ceiling(graph, in)};
    ImageId const shadow_bounds = add_shadow_bounds(graph, in, shadow.cascades);
    TerrainLight const terrain_light = add_terrain_light(graph, in, frame, tables.over_terrain, shadow.ceiling);
    ImageId toned;
    for (int sample = 0; sample < in.settings.aa; ++sample) {
        if (sample > 0) frame = graph.add_constants(in.constants[static_cast<std::size_t>(sample)]);
        GBuffer const gbuffer = add_gbuffer(graph, in, frame, sample);
        WorkListId const pixels = add_pixel_work(graph, gbuffer.depth);
        ImageId const open = add_ambient_occlusion(graph, in, frame, gbuffer, pixels, terrain_light.surfaces, sample);
        AirLayer const air = add_air(graph, in, frame, {gbuffer.depth, shadow, shadow_bounds, terrain_light.air}, tables, sample);
        ImageId const lit = add_lighting(graph, in, frame, {gbuffer, open, air, terrain_light.surfaces, pixels}, shadow, tables, sample);
        if (sample == 0) add_exposure(graph, lit, exposure, in.settings, in.seconds);
        toned = add_accumulate(graph, lit, mean, exposure, in.settings, sample);
    }
    if (!in.settings.show.empty()) {
        add_show(graph, in.settings, exposure, picture);
    } else if (in.settings.post_aa == "fxaa") {
        add_post_aa(graph, add_display(graph, toned, in.settings), picture);
    } else {
        add_display_to(graph, toned, in.settings, picture);
    }
}

} // namespace alpenglow
