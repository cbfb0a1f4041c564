#include "render/passes/sunlight.h"

#include "interop/atmosphere.h"
#include "interop/sunlight.h"

#include <embedded_shaders.h>

namespace alpenglow {

AirTableStep sunlight_step(std::size_t table, std::size_t transmittance) {
    constexpr std::uint32_t GROUPS = TRANSMITTANCE_WIDTH / WORKGROUP_SIZE * TRANSMITTANCE_HEIGHT / WORKGROUP_SIZE;
    return {.pass = "sunlight",
            .shader = shaders::sunlight_comp,
            .groups = GROUPS,
            .reads = {{transmittance, SUNLIGHT_TRANSMITTANCE_SLOT}},
            .makes = {table, SUNLIGHT_TABLE_SLOT}};
}

} // namespace alpenglow
