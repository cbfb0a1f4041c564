#include "interop/models/tables.h"

#include "render/models/model.h"
#include "render/passes/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

namespace {

enum Tables : std::size_t { TRANSMITTANCE, ISOTROPIC, SKY_LIGHT };

struct Maker {
    FrameGraph& graph;
    AirTableInputs const& inputs;

    /// A pass that fills `table` from those before it.
    void fill(std::string const& name, ShaderCode const& shader, ImageId table, Extent threads) const {
        std::vector<Slot> slots{constants(TABLE_FRAME_SLOT, inputs.frame),
                                sampled(TABLE_TRANSMITTANCE_SLOT, inputs.tables[TRANSMITTANCE]),
                                stored(TABLE_RESULT_SLOT, table)};
        if (table.index != inputs.tables[ISOTROPIC].index)
            slots.push_back(sampled(TABLE_ISOTROPIC_SLOT, inputs.tables[ISOTROPIC]));
        graph.add(ComputePass{name, shader, std::move(slots), threads});
    }

    /// A table that is made for each frame.
    ImageId add_view_table(std::string const& name, ShaderCode const& shader, Extent size, Extent threads) const {
        ImageId const table = graph.add_image(name, {VK_FORMAT_R32G32B32A32_SFLOAT, size}, ShowScale::radiance);
        fill(name, shader, table, threads);
        return table;
    }
};

std::vector<Slot> add_tables(FrameGraph& graph, AirTableInputs const& inputs) {
    Maker const make{graph, inputs};
    if (inputs.stale) {
        add_transmittance(graph, inputs.frame, inputs.tables[TRANSMITTANCE]);
        Extent const isotropic{ISOTROPIC_SIZE, ISOTROPIC_SIZE}, sky{SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT};
        make.fill("isotropic_scattering", shaders::isotropic_scattering_comp, inputs.tables[ISOTROPIC], isotropic);
        make.fill("sky_light", shaders::sky_light_comp, inputs.tables[SKY_LIGHT], sky);
    }
    Extent const sky_view{SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT}, aerial{AERIAL_SLICES * AERIAL_SIZE, 2 * AERIAL_SIZE};
    return {sampled(TABLES_TRANSMITTANCE_SLOT, inputs.tables[TRANSMITTANCE]),
            sampled(TABLES_ISOTROPIC_SLOT, inputs.tables[ISOTROPIC]),
            sampled(TABLES_SKY_LIGHT_SLOT, inputs.tables[SKY_LIGHT]),
            sampled(TABLES_SKY_VIEW_SLOT, make.add_view_table("sky_view", shaders::sky_view_comp, sky_view, sky_view)),
            sampled(TABLES_AERIAL_SLOT, make.add_view_table("aerial_perspective", shaders::aerial_perspective_comp,
                                                            aerial, {AERIAL_SIZE, AERIAL_SIZE}))};
}

std::string_view limits(World const& world, Settings const& settings, bool meshes) {
    double const altitude = glm::length(world.camera.position) - world.planet.radius;
    if (altitude > world.planet.air.top_altitude)
        return "from outside the air its tables of the view don't apply: each pixel is marched, without light shafts";
    return meshes && settings.shafts ? "nothing but the planet shades the air: there are no light shafts"
                                     : std::string_view();
}

} // namespace

AirModel make_tables() {
    return {.name = "tables",
            .help = "sky and aerial perspective from tables of the view, further orders isotropic",
            .lighting = shaders::lighting_tables_comp,
            .tables = {{"transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"isotropic_scattering", {ISOTROPIC_SIZE, ISOTROPIC_SIZE}, ShowScale::logarithm},
                       {"sky_light", {SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT}, ShowScale::logarithm}},
            .add_tables = add_tables,
            .limits = limits};
}

} // namespace alpenglow
