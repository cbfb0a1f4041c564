#pragma once

#include "render/models/model.h"

namespace alpenglow {

/// Makes a model's table of optical depth to the top of the air, as shaders/atmosphere/transmittance.glsl reads it.
AirTableStep transmittance_step(std::size_t table);

} // namespace alpenglow
