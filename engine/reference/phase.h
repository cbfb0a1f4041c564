#pragma once

#include "scene/phase.h"

namespace alpenglow {

/// A cosine distributed as the phase, from a number in (0, 1): the inverse of each lobe's distribution, which is exact
/// for Henyey-Greenstein's and Rayleigh's; for the others Newton's method goes to 1e-12. The lobes take turns.
double sample_phase_cosine(PhaseLobes const& lobes, double u);

} // namespace alpenglow
