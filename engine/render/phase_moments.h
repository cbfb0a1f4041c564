#pragma once

#include "interop/atmosphere.h"

#include <functional>

namespace alpenglow {

/// A phase [1/sr] by the cosine of the angle that light is turned by; 1 over the sphere.
using PhaseFunction = std::function<double(double cosine)>;

double rayleigh_phase(double cosine);
/// Cornette and Shanks 1992, -1 < g < 1.
double cornette_shanks_phase(double cosine, double g);

/// The phase's Legendre coefficients by quadrature, for light scattered more than once. The share f that is taken to go
/// straight on is the coefficient of degree 10: a tenth where g = 0.8 (docs/decisions/0006). Good to 1e-6 for phases
/// whose forward peak is no narrower than 0.1 degree.
shader::PhaseMoments phase_moments(PhaseFunction const& phase);

} // namespace alpenglow
