#pragma once

namespace alpenglow {

/// How a medium spreads the light that it scatters. The cosine is between the directions of travel before and after:
/// 1 is straight on.
struct Phase {
    enum class Kind { isotropic, rayleigh, henyey_greenstein, double_henyey_greenstein, cornette_shanks };

    Kind kind = Kind::isotropic;
    double g = 0;             ///< asymmetry, -1 < g < 1; of the first lobe where there are two
    double second_g = 0;      ///< of the second lobe
    double second_weight = 0; ///< share of the second lobe, 0..1
};

/// [1/sr]; integrates to 1 over the sphere. Rayleigh without polarization: Chandrasekhar, Radiative Transfer (1950),
/// chapter I, section 3. Henyey and Greenstein 1941, Eq. 2. Cornette and Shanks 1992, Eq. 8 (over 4 pi), which is taken
/// as Rayleigh where |g| < 1e-5 (3e-5 apart).
double phase_value(Phase const& phase, double cosine);

/// A cosine distributed as the phase, from a number in (0, 1): the inverse of the distribution, which is exact for all
/// but Cornette-Shanks, where Newton's method goes to 1e-12.
double sample_phase_cosine(Phase const& phase, double u);

} // namespace alpenglow
