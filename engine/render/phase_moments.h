#pragma once

#include "interop/atmosphere.h"
#include "scene/phase.h"

namespace alpenglow {

/// The share f of a phase's light that is taken to go straight on when light is scattered more than once: the Legendre
/// coefficient of degree 10, an eighth for Earth's aerosol (docs/atmosphere.md). 0 for Rayleigh and isotropic
/// phases, and for those that look back rather than on, whose odd degrees are negative.
double straight_on_share(PhaseLobes const& lobes);

/// The phase's Legendre coefficients of degrees 0 to 4, less that share.
shader::PhaseMoments phase_moments(PhaseLobes const& lobes);

} // namespace alpenglow
