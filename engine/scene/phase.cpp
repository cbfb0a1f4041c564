#include "scene/phase.h"

#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

/// Mean of cosine^2 in Henyey and Greenstein's lobe.
double mean_square(double g) { return (1 + 2 * g * g) / 3; }

double lobe_value(PhaseLobe const& lobe, double cosine) {
    double const g = lobe.g;
    double const d = (1 - g) * (1 - g) + 2 * g * (1 - cosine);
    double const shape = (1 + lobe.alpha * cosine * cosine) / (1 + lobe.alpha * mean_square(g));
    return (1 - g * g) * shape / (4 * std::numbers::pi * d * std::sqrt(d));
}

/// Henyey and Greenstein's coefficients are g^l; x P_l = ((l + 1) P_{l+1} + l P_{l-1}) / (2 l + 1), twice, gives those
/// of cosine^2 times it.
double lobe_legendre(PhaseLobe const& lobe, int l) {
    double const g = lobe.g, n = l;
    double square = std::pow(g, l) * ((n + 1) * (n + 1) / ((2 * n + 1) * (2 * n + 3)));
    square += std::pow(g, l + 2) * ((n + 1) * (n + 2) / ((2 * n + 1) * (2 * n + 3)));
    if (l >= 1) square += std::pow(g, l) * (n * n / ((2 * n + 1) * (2 * n - 1)));
    if (l >= 2) square += std::pow(g, l - 2) * (n * (n - 1) / ((2 * n + 1) * (2 * n - 1)));
    return (std::pow(g, l) + lobe.alpha * square) / (1 + lobe.alpha * mean_square(g));
}

/// `d` [micrometres]
PhaseLobes droplet_lobes(double d) {
    return {{std::exp(-0.0990567 / (d - 1.67154)), 0},
            {std::exp(-2.20679 / (d + 3.91029) - 0.428934), std::exp(3.62489 - 8.29288 / (d + 5.52825))},
            std::exp(-0.599085 / (d - 0.641583) - 0.665888)};
}

} // namespace

PhaseLobes lobes_of(Phase const& phase) {
    switch (phase.kind) {
    case Phase::Kind::isotropic:
        return {};
    case Phase::Kind::rayleigh:
        return {.first = {0, 1}};
    case Phase::Kind::henyey_greenstein:
        return {.first = {phase.g, 0}};
    case Phase::Kind::double_henyey_greenstein:
        return {{phase.g, 0}, {phase.second_g, 0}, phase.second_weight};
    case Phase::Kind::cornette_shanks:
        return {.first = {phase.g, 1}};
    case Phase::Kind::droplets:
        return droplet_lobes(1e6 * phase.diameter);
    }
    return {};
}

double phase_value(PhaseLobes const& lobes, double cosine) {
    double const first = lobe_value(lobes.first, cosine);
    if (lobes.second_share == 0) return first;
    return first + lobes.second_share * (lobe_value(lobes.second, cosine) - first);
}

double phase_legendre(PhaseLobes const& lobes, int l) {
    return (1 - lobes.second_share) * lobe_legendre(lobes.first, l) +
           lobes.second_share * lobe_legendre(lobes.second, l);
}

} // namespace alpenglow
