#include "interop/models/march.h"

#include "interop/multiple_scattering.h"
#include "interop/sky_irradiance.h"
#include "render/models/model.h"
#include "render/passes/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

namespace {

enum Tables : std::size_t { TRANSMITTANCE, MULTIPLE_SCATTERING, SKY_IRRADIANCE };

std::vector<Slot> add_tables(FrameGraph& graph, AirTableInputs const& inputs) {
    ImageId const transmittance = inputs.tables[TRANSMITTANCE];
    ImageId const multiple_scattering = inputs.tables[MULTIPLE_SCATTERING];
    ImageId const sky_irradiance = inputs.tables[SKY_IRRADIANCE];
    std::vector<Slot> const slots{sampled(MARCH_TRANSMITTANCE_SLOT, transmittance),
                                  sampled(MARCH_MULTIPLE_SCATTERING_SLOT, multiple_scattering),
                                  sampled(MARCH_SKY_IRRADIANCE_SLOT, sky_irradiance)};
    if (!inputs.stale) return slots;
    add_transmittance(graph, inputs.frame, transmittance);
    graph.add(ComputePass{"multiple_scattering",
                          shaders::multiple_scattering_comp,
                          {constants(MULTIPLE_SCATTERING_FRAME_SLOT, inputs.frame),
                           sampled(MULTIPLE_SCATTERING_TRANSMITTANCE_SLOT, transmittance),
                           stored(MULTIPLE_SCATTERING_TABLE_SLOT, multiple_scattering)},
                          graph.shape(multiple_scattering).extent});
    graph.add(ComputePass{"sky_irradiance",
                          shaders::sky_irradiance_comp,
                          {constants(SKY_IRRADIANCE_FRAME_SLOT, inputs.frame),
                           sampled(SKY_IRRADIANCE_TRANSMITTANCE_SLOT, transmittance),
                           sampled(SKY_IRRADIANCE_MULTIPLE_SCATTERING_SLOT, multiple_scattering),
                           stored(SKY_IRRADIANCE_TABLE_SLOT, sky_irradiance)},
                          graph.shape(sky_irradiance).extent});
    return slots;
}

} // namespace

AirModel make_march() {
    return {.name = "march",
            .help = "each pixel's ray marched; the sun's way and all further orders from tables",
            .lighting = shaders::lighting_march_comp,
            .tables = {{"transmittance", {TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT}, ShowScale::optical_depth},
                       {"multiple_scattering",
                        {MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT},
                        ShowScale::logarithm},
                       {"sky_irradiance", {SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT}, ShowScale::logarithm}},
            .add_tables = add_tables,
            .limits = [](World const&, Settings const&, bool) -> std::string_view { return {}; }};
}

} // namespace alpenglow
