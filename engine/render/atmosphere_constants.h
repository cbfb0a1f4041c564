#pragma once

#include "interop/atmosphere.h"
#include "scene/planet.h"

namespace alpenglow {

/// The planet's air as shaders see it. What is switched off keeps its place, with coefficients of 0, so that no shader
/// is compiled anew.
shader::Atmosphere atmosphere_of(Planet const& planet);

} // namespace alpenglow
