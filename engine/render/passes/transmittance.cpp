#include "render/passes/transmittance.h"

#include "interop/atmosphere.h"
#include "interop/transmittance.h"

#include <embedded_shaders.h>

namespace alpenglow {

AirTableStep transmittance_step(std::size_t table) {
    constexpr std::uint32_t GROUPS = TRANSMITTANCE_WIDTH / WORKGROUP_SIZE * TRANSMITTANCE_HEIGHT / WORKGROUP_SIZE;
    return {.pass = "transmittance",
            .shader = shaders::transmittance_comp,
            .groups = GROUPS,
            .frame_slot = TRANSMITTANCE_FRAME_SLOT,
            .reads = {},
            .makes = {table, TRANSMITTANCE_TABLE_SLOT}};
}

} // namespace alpenglow
