#include "reference/phase.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double QUARTER_OVER_PI = 1 / (4 * M_PI);
constexpr double LEAST_G = 1e-5; ///< below it Cornette-Shanks is taken as Rayleigh, Henyey-Greenstein as isotropic

double rayleigh_value(double cosine) { return 0.75 * QUARTER_OVER_PI * (1 + cosine * cosine); }

double henyey_greenstein_value(double g, double cosine) {
    double const d = 1 + g * g - 2 * g * cosine;
    return QUARTER_OVER_PI * (1 - g * g) / (d * std::sqrt(d));
}

/// m^3 + 3 m = 8 u - 4, by Cardano.
double sample_rayleigh(double u) {
    double const q = 4 * u - 2;
    double const a = std::cbrt(q + std::sqrt(q * q + 1));
    return a - 1 / a;
}

double sample_henyey_greenstein(double g, double u) {
    if (std::abs(g) < LEAST_G) return 2 * u - 1;
    double const s = (1 - g * g) / (1 - g + 2 * g * u);
    return std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
}

/// The share of Cornette-Shanks' light with a cosine below this one: with s^2 = 1 + g^2 - 2 g m the integrand is a
/// polynomial in s over s^2. `drop` is s(-1) - s, factored out so that little is lost for small g.
double cornette_shanks_share(double g, double cosine) {
    double const k = 1 + g * g, s0 = 1 + g, s = std::sqrt(k - 2 * g * cosine);
    double const drop = 2 * g * (1 + cosine) / (s0 + s);
    double const squares = (k * k / (s * s0) - 2 * k + (s * s + s * s0 + s0 * s0) / 3) / (4 * g * g);
    return 1.5 * (1 - g * g) / (2 * (2 + g * g)) * drop / g * (1 / (s * s0) + squares);
}

/// Newton's method, kept inside a bracket that shrinks, from Henyey and Greenstein's cosine.
double sample_cornette_shanks(Phase const& phase, double u) {
    if (std::abs(phase.g) < LEAST_G) return sample_rayleigh(u);
    double low = -1, high = 1, cosine = sample_henyey_greenstein(phase.g, u);
    for (int i = 0; i < 50; ++i) {
        double const excess = cornette_shanks_share(phase.g, cosine) - u;
        (excess > 0 ? high : low) = cosine;
        double next = cosine - excess / (2 * M_PI * phase_value(phase, cosine));
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - cosine) < 1e-12) return next;
        cosine = next;
    }
    return cosine;
}

} // namespace

double phase_value(Phase const& phase, double cosine) {
    switch (phase.kind) {
    case Phase::Kind::isotropic: return QUARTER_OVER_PI;
    case Phase::Kind::rayleigh: return rayleigh_value(cosine);
    case Phase::Kind::henyey_greenstein: return henyey_greenstein_value(phase.g, cosine);
    case Phase::Kind::double_henyey_greenstein:
        return (1 - phase.second_weight) * henyey_greenstein_value(phase.g, cosine) +
               phase.second_weight * henyey_greenstein_value(phase.second_g, cosine);
    case Phase::Kind::cornette_shanks:
        if (std::abs(phase.g) < LEAST_G) return rayleigh_value(cosine);
        return henyey_greenstein_value(phase.g, cosine) * 1.5 * (1 + cosine * cosine) / (2 + phase.g * phase.g);
    }
    return 0;
}

double sample_phase_cosine(Phase const& phase, double u) {
    switch (phase.kind) {
    case Phase::Kind::isotropic: return 2 * u - 1;
    case Phase::Kind::rayleigh: return sample_rayleigh(u);
    case Phase::Kind::henyey_greenstein: return sample_henyey_greenstein(phase.g, u);
    case Phase::Kind::double_henyey_greenstein: {
        double const w = phase.second_weight;
        return u < w ? sample_henyey_greenstein(phase.second_g, u / w)
                     : sample_henyey_greenstein(phase.g, (u - w) / (1 - w));
    }
    case Phase::Kind::cornette_shanks: return sample_cornette_shanks(phase, u);
    }
    return 0;
}

} // namespace alpenglow
