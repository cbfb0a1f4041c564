#pragma once

namespace alpenglow {

/// How a medium spreads the light that it scatters, as planet files choose it. The cosine is between the directions of
/// travel before and after: 1 is straight on, so that a forward peak has g > 0 and lies around the sun's disc.
struct Phase {
    enum class Kind { isotropic, rayleigh, henyey_greenstein, double_henyey_greenstein, cornette_shanks, droplets };

    Kind kind = Kind::isotropic;
    double g = 0;             ///< asymmetry, -1 < g < 1; of the first lobe where there are two
    double second_g = 0;      ///< of the second lobe
    double second_weight = 0; ///< share of the second lobe, 0..1
    double diameter = 1e-5;   ///< [m] of droplets, 5e-6..5e-5

    bool operator==(Phase const&) const = default;
};

/// One lobe after Draine 2003: Henyey and Greenstein's times (1 + alpha cosine^2), normalised to 1 over the sphere. It
/// is Henyey-Greenstein at alpha = 0, Cornette-Shanks at alpha = 1, Rayleigh at g = 0, alpha = 1.
struct PhaseLobe {
    double g = 0;
    double alpha = 0;

    bool operator==(PhaseLobe const&) const = default;
};

/// Every phase is a blend of two lobes.
struct PhaseLobes {
    PhaseLobe first{}, second{};
    double second_share = 0; ///< 0..1

    bool operator==(PhaseLobes const&) const = default;
};

/// Droplets: Jendersie and d'Eon 2023, An Approximate Mie Scattering Function for Fog and Cloud Rendering, their fit
/// for water droplets of 5 to 50 micrometres.
PhaseLobes lobes_of(Phase const& phase);

/// [1/sr]; integrates to 1 over the sphere. Without polarization.
double phase_value(PhaseLobes const& lobes, double cosine);

/// The integral over the sphere of the phase times Legendre's polynomial of degree l >= 0: 1 for l = 0, the asymmetry
/// (mean cosine) for l = 1. The phase is the sum over l of (2 l + 1) / (4 pi) times it times P_l(cosine).
double phase_legendre(PhaseLobes const& lobes, int l);
inline double phase_legendre(Phase const& phase, int l) { return phase_legendre(lobes_of(phase), l); }

} // namespace alpenglow
