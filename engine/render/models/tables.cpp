#include "interop/models/tables.h"

#include "render/models/model.h"
#include "render/passes/sunlight.h"
#include "render/passes/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

namespace {

enum Tables : std::size_t { TRANSMITTANCE, SUNLIGHT, ISOTROPIC, SKY_LIGHT };

/// A step that makes `table`, of `size`, from those before it.
AirTableStep step_for(std::string const& pass, ShaderCode const& shader, Tables table, Extent size) {
    AirTableStep step{.pass = pass,
                      .shader = shader,
                      .groups = size.width / WORKGROUP_SIZE * size.height / WORKGROUP_SIZE,
                      .reads = {{SUNLIGHT, TABLE_SUNLIGHT_SLOT}},
                      .makes = {table, TABLE_RESULT_SLOT}};
    if (table != ISOTROPIC) step.reads.push_back({ISOTROPIC, TABLE_ISOTROPIC_SLOT});
    return step;
}

/// A table that is made for each frame.
ImageId add_view_table(FrameGraph& graph, AirTableInputs const& inputs, std::string const& name,
                       ShaderCode const& shader, Extent size, Extent threads) {
    ImageId const table = graph.add_image(name, {VK_FORMAT_R32G32B32A32_SFLOAT, size}, ShowScale::radiance);
    graph.add(ComputePass{name,
                          shader,
                          {constants(FRAME_SLOT, inputs.frame),
                           sampled(TABLE_SUNLIGHT_SLOT, inputs.tables[SUNLIGHT]),
                           sampled(TABLE_ISOTROPIC_SLOT, inputs.tables[ISOTROPIC]), stored(TABLE_RESULT_SLOT, table)},
                          threads});
    return table;
}

std::vector<Slot> model_slots(FrameGraph& graph, AirTableInputs const& inputs) {
    Extent const sky_view{SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT}, aerial{AERIAL_SLICES * AERIAL_SIZE, 2 * AERIAL_SIZE};
    return {sampled(TABLES_SUNLIGHT_SLOT, inputs.tables[SUNLIGHT]),
            sampled(TABLES_ISOTROPIC_SLOT, inputs.tables[ISOTROPIC]),
            sampled(TABLES_SKY_LIGHT_SLOT, inputs.tables[SKY_LIGHT]),
            sampled(TABLES_SKY_VIEW_SLOT,
                    add_view_table(graph, inputs, "sky_view", shaders::sky_view_comp, sky_view, sky_view)),
            sampled(TABLES_AERIAL_SLOT, add_view_table(graph, inputs, "aerial_perspective",
                                                       shaders::aerial_perspective_comp, aerial,
                                                       {AERIAL_SIZE, AERIAL_SIZE})),
            sampled(TABLES_TRANSMITTANCE_SLOT, inputs.tables[TRANSMITTANCE])};
}

std::string_view limits(World const& world, Settings const& settings, bool meshes) {
    double const altitude = glm::length(world.camera.position) - world.planet.radius;
    if (altitude > world.planet.air.top_altitude)
        return "from outside the air its tables of the view don't apply: each pixel is marched, without light shafts";
    return meshes && settings.shafts != "off" ? "nothing but the planet shades the air: there are no light shafts"
                                     : std::string_view();
}

std::vector<AirTableStep> const& steps(shader::Atmosphere const&) {
    static std::vector<AirTableStep> const STEPS{
        transmittance_step(TRANSMITTANCE),
        sunlight_step(SUNLIGHT, TRANSMITTANCE),
        step_for("isotropic_scattering", shaders::isotropic_scattering_comp, ISOTROPIC, {ISOTROPIC_SIZE, ISOTROPIC_SIZE}),
        step_for("sky_light", shaders::sky_light_comp, SKY_LIGHT, {SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT})};
    return STEPS;
}

} // namespace

AirModel make_tables() {
    return {.name = "tables",
            .help = "sky and aerial perspective from tables of the view, further orders isotropic",
            .air = shaders::air_tables_comp,
            .air_repair = shaders::air_repair_tables_comp,
            .lighting = shaders::lighting_tables_comp,
            .tables = {{"transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"sunlight", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"isotropic_scattering", {ISOTROPIC_SIZE, ISOTROPIC_SIZE}, ShowScale::logarithm},
                       {"sky_light", {SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT}, ShowScale::logarithm}},
            .steps = steps,
            .slots = model_slots,
            .limits = limits};
}

} // namespace alpenglow
