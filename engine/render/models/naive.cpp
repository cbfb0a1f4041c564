#include "render/models/model.h"

#include <embedded_shaders.h>

namespace alpenglow {

namespace {

std::string_view limits(World const& world, Settings const&, bool) {
    bool const sun_is_up = glm::dot(world.camera.position, world.to_sun) > 0;
    return sun_is_up ? "light that is scattered more than once is left out: skies and shadows are too dark"
                     : "light that is scattered more than once is left out, which is most of it after sunset";
}

} // namespace

AirModel make_naive() {
    return {.name = "naive",
            .help = "single scattering, both integrals marched in each pixel, no tables",
            .air = shaders::air_naive_comp,
            .air_repair = shaders::air_repair_naive_comp,
            .lighting = shaders::lighting_naive_comp,
            .slots = [](FrameGraph&, AirTableInputs const&) { return std::vector<Slot>{}; },
            .limits = limits};
}

} // namespace alpenglow
