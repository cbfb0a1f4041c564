#pragma once

#include "render/models/model.h"

namespace alpenglow {

/// Makes a model's table of the light of the sun's disc from that of optical depth, as shaders/atmosphere/sunlight.glsl reads it.
AirTableStep sunlight_step(std::size_t table, std::size_t transmittance);

} // namespace alpenglow
