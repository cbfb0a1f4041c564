#pragma once

#include "core/settings.h"
#include "scene/air.h"

namespace alpenglow {

/// A switch for each component of the planet's air, and a choice of phase for those that scatter: the settings
/// `air_without` and `air_phases`.
void edit_air(Settings& settings, Air const& planet_air);

} // namespace alpenglow
