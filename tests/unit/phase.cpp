#include "scene/phase.h"
#include "support/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

using Kind = Phase::Kind;

std::vector<Phase> const PHASES = {{Kind::isotropic},
                                   {Kind::rayleigh},
                                   {Kind::henyey_greenstein, 0.76},
                                   {Kind::henyey_greenstein, -0.4},
                                   {Kind::henyey_greenstein, 0.95},
                                   {Kind::double_henyey_greenstein, 0.8, -0.5, 0.3},
                                   {Kind::cornette_shanks, 0},
                                   {Kind::cornette_shanks, 0.8},
                                   {Kind::cornette_shanks, -0.6},
                                   {Kind::droplets, 0, 0, 0, 5e-6},
                                   {Kind::droplets, 0, 0, 0, 2e-5},
                                   {Kind::droplets, 0, 0, 0, 5e-5}};

std::string name(Phase const& phase) {
    return "kind " + std::to_string(static_cast<int>(phase.kind)) + ", g " + std::to_string(phase.g) + ", diameter " +
           std::to_string(phase.diameter);
}

double legendre(int l, double x) { return std::legendre(static_cast<unsigned>(l), x); }

/// By quadrature, in pieces that halve towards both ends, where narrow lobes are.
double coefficient(Phase const& phase, int l) {
    static GaussLegendre const rule(24);
    PhaseLobes const lobes = lobes_of(phase);
    auto const integrand = [&](double c) { return 2 * std::numbers::pi * phase_value(lobes, c) * legendre(l, c); };
    double sum = 0;
    for (double const side : {-1.0, 1.0}) {
        double width = 1;
        for (; width > 1e-11; width /= 2) {
            double const inner = side * (1 - width), outer = side * (1 - width / 2);
            sum += rule.integrate(std::min(inner, outer), std::max(inner, outer), integrand);
        }
        sum += width * integrand(side); // even there: lobes are wider than 1e-6
    }
    return sum;
}

double lobe(double g, double c) { return (1 - g * g) / (4 * std::numbers::pi) / std::pow(1 + g * g - 2 * g * c, 1.5); }

} // namespace

TEST(Phase, integrates_to_one) {
    for (Phase const& phase : PHASES) EXPECT_NEAR(coefficient(phase, 0), 1, 1e-9) << name(phase);
}

TEST(Phase, legendre_coefficients_are_those_of_the_quadrature) {
    for (Phase const& phase : PHASES) {
        for (int l = 0; l <= 8; ++l)
            EXPECT_NEAR(phase_legendre(phase, l), coefficient(phase, l), 1e-8) << name(phase) << ", degree " << l;
    }
}

TEST(Phase, coefficients_known_elsewhere) {
    EXPECT_DOUBLE_EQ(phase_legendre({Kind::rayleigh}, 2), 0.1);
    EXPECT_DOUBLE_EQ(phase_legendre({Kind::rayleigh}, 4), 0);
    EXPECT_NEAR(phase_legendre({Kind::henyey_greenstein, 0.7}, 5), std::pow(0.7, 5), 1e-15);
    // Cornette and Shanks 1992: the asymmetry is 3 g (4 + g^2) / (5 (2 + g^2)).
    EXPECT_NEAR(phase_legendre({Kind::cornette_shanks, 0.8}, 1), 3 * 0.8 * 4.64 / (5 * 2.64), 1e-14);
    EXPECT_NEAR(phase_legendre({Kind::double_henyey_greenstein, 0.8, -0.5, 0.3}, 1), 0.7 * 0.8 - 0.3 * 0.5, 1e-15);
}

TEST(Phase, values_are_the_formulas) {
    double const c = 0.3, pi = std::numbers::pi;
    auto const value = [&](Phase const& phase) { return phase_value(lobes_of(phase), c); };
    EXPECT_DOUBLE_EQ(value({Kind::isotropic}), 1 / (4 * pi));
    EXPECT_DOUBLE_EQ(value({Kind::rayleigh}), 3 / (16 * pi) * 1.09);
    EXPECT_NEAR(value({Kind::henyey_greenstein, 0.7}), lobe(0.7, c), 1e-14);
    EXPECT_NEAR(value({Kind::double_henyey_greenstein, 0.8, -0.5, 0.3}), 0.7 * lobe(0.8, c) + 0.3 * lobe(-0.5, c),
                1e-14);
    EXPECT_NEAR(value({Kind::cornette_shanks, 0.8}), 1.5 * 1.09 / (2 + 0.64) * lobe(0.8, c), 1e-14);
}

TEST(Phase, droplets_are_a_sharp_lobe_and_a_wide_one) {
    // The printed fit at 10 micrometres, worked out by hand.
    PhaseLobes const lobes = lobes_of({Kind::droplets, 0, 0, 0, 1e-5});
    EXPECT_NEAR(lobes.first.g, std::exp(-0.0990567 / 8.32846), 1e-12);
    EXPECT_NEAR(lobes.first.g, 0.98818, 1e-5);
    EXPECT_NEAR(lobes.second.g, 0.55567, 1e-5);
    EXPECT_NEAR(lobes.second.alpha, 21.9955, 1e-4);
    EXPECT_NEAR(lobes.second_share, 0.48196, 1e-5);
    // Mie theory's asymmetry of water droplets of 10 micrometres in visible light is about 0.85.
    EXPECT_NEAR(phase_legendre({Kind::droplets, 0, 0, 0, 1e-5}, 1), 0.86, 0.02);
}
