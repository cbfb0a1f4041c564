#include "render/passes/air_tables.h"

#include "interop/multiple_scattering.h"
#include "interop/sky_irradiance.h"
#include "interop/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame) {
    bool const kept = !in.air_is_stale;
    AirTables const air{graph.import(in.transmittance, "transmittance", ShowScale::optical_depth, kept),
                        graph.import(in.multiple_scattering, "multiple_scattering", ShowScale::logarithm, kept),
                        graph.import(in.sky_irradiance, "sky_irradiance", ShowScale::logarithm, kept)};
    if (kept) return air;
    graph.add(
        ComputePass{"transmittance",
                    shaders::transmittance_comp,
                    {constants(TRANSMITTANCE_FRAME_SLOT, frame), stored(TRANSMITTANCE_TABLE_SLOT, air.transmittance)},
                    in.transmittance.shape().extent});
    graph.add(ComputePass{"multiple_scattering",
                          shaders::multiple_scattering_comp,
                          {constants(MULTIPLE_SCATTERING_FRAME_SLOT, frame),
                           sampled(MULTIPLE_SCATTERING_TRANSMITTANCE_SLOT, air.transmittance),
                           stored(MULTIPLE_SCATTERING_TABLE_SLOT, air.multiple_scattering)},
                          in.multiple_scattering.shape().extent});
    graph.add(ComputePass{"sky_irradiance",
                          shaders::sky_irradiance_comp,
                          {constants(SKY_IRRADIANCE_FRAME_SLOT, frame),
                           sampled(SKY_IRRADIANCE_TRANSMITTANCE_SLOT, air.transmittance),
                           sampled(SKY_IRRADIANCE_MULTIPLE_SCATTERING_SLOT, air.multiple_scattering),
                           stored(SKY_IRRADIANCE_TABLE_SLOT, air.sky_irradiance)},
                          in.sky_irradiance.shape().extent});
    return air;
}

} // namespace alpenglow
