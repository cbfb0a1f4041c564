#include "reference/phase.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr double LEAST_G = 1e-5; ///< below it a lobe is taken as even or as a parabola in the cosine

/// Of 1 + alpha m^2, by Cardano: alpha m^3 + 3 m = (3 + alpha) (2 u - 1).
double sample_parabola(double alpha, double u) {
    if (alpha == 0) return 2 * u - 1;
    double const p = 1 / alpha, q = (3 + alpha) / (2 * alpha) * (2 * u - 1);
    double const a = std::cbrt(std::abs(q) + std::sqrt(q * q + p * p * p));
    return std::copysign(a - p / a, q);
}

double sample_henyey_greenstein(double g, double u) {
    double const s = (1 - g * g) / (1 - g + 2 * g * u);
    return std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
}

/// The share of a lobe's light with a cosine below this one: with s^2 = 1 + g^2 - 2 g m the integrand is a polynomial
/// in s over s^2. `drop` is s(-1) - s, factored out so that little is lost for small g.
double lobe_share(PhaseLobe const& lobe, double cosine) {
    double const g = lobe.g, k = 1 + g * g, s0 = 1 + g, s = std::sqrt(k - 2 * g * cosine);
    double const drop = 2 * g * (1 + cosine) / (s0 + s);
    double const squares = (k * k / (s * s0) - 2 * k + (s * s + s * s0 + s0 * s0) / 3) / (4 * g * g);
    double const whole = 1 + lobe.alpha * (1 + 2 * g * g) / 3;
    return 0.5 * (1 - g * g) / whole * drop / g * (1 / (s * s0) + lobe.alpha * squares);
}

/// Newton's method, kept inside a bracket that shrinks, from Henyey and Greenstein's cosine.
double sample_lobe(PhaseLobe const& lobe, double u) {
    if (std::abs(lobe.g) < LEAST_G) return sample_parabola(lobe.alpha, u);
    double low = -1, high = 1, cosine = sample_henyey_greenstein(lobe.g, u);
    if (lobe.alpha == 0) return cosine;
    PhaseLobes const alone{.first = lobe};
    for (int i = 0; i < 50; ++i) {
        double const excess = lobe_share(lobe, cosine) - u;
        (excess > 0 ? high : low) = cosine;
        double next = cosine - excess / (2 * M_PI * phase_value(alone, cosine));
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - cosine) < 1e-12) return next;
        cosine = next;
    }
    return cosine;
}

} // namespace

double sample_phase_cosine(PhaseLobes const& lobes, double u) {
    double const share = lobes.second_share;
    return u < share ? sample_lobe(lobes.second, u / share) : sample_lobe(lobes.first, (u - share) / (1 - share));
}

} // namespace alpenglow
