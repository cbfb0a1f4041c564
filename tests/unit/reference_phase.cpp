#include "reference/phase.h"
#include "support/gauss_legendre.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

using Kind = Phase::Kind;

std::vector<Phase> const PHASES = {{Kind::isotropic},
                                   {Kind::rayleigh},
                                   {Kind::henyey_greenstein, 0},
                                   {Kind::henyey_greenstein, 0.76},
                                   {Kind::henyey_greenstein, -0.4},
                                   {Kind::henyey_greenstein, 0.95},
                                   {Kind::double_henyey_greenstein, 0.8, -0.5, 0.3},
                                   {Kind::cornette_shanks, 0},
                                   {Kind::cornette_shanks, 1e-3},
                                   {Kind::cornette_shanks, 0.8},
                                   {Kind::cornette_shanks, -0.6}};

std::string name(Phase const& phase) {
    return "kind " + std::to_string(static_cast<int>(phase.kind)) + ", g " + std::to_string(phase.g);
}

/// The integral of the phase times f(cosine) over all directions with cosines in [low, high].
template <typename F> double over_sphere(Phase const& phase, double low, double high, F const& f) {
    static GaussLegendre const rule(24);
    double sum = 0;
    // Pieces halve towards both ends, where narrow lobes are.
    for (double width = 1; width > 1e-5; width /= 2)
        for (double const side : {-1.0, 1.0}) {
            double const inner = side * (1 - width), outer = side * (width > 2e-5 ? 1 - width / 2 : 1);
            double const a = std::max(low, std::min(inner, outer)), b = std::min(high, std::max(inner, outer));
            if (a < b)
                sum +=
                    rule.integrate(a, b, [&](double c) { return 2 * std::numbers::pi * phase_value(phase, c) * f(c); });
        }
    return sum;
}

double share(Phase const& phase, double low, double high) {
    return over_sphere(phase, low, high, [](double) { return 1.0; });
}

/// Chi-square of cosines drawn as `drawn`, binned, against the integrals of `expected`.
ChiSquare compare(Phase const& drawn, Phase const& expected) {
    constexpr int BINS = 64, COUNT = 200000;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform;
    std::vector<int> hits(BINS);
    for (int i = 0; i < COUNT; ++i) {
        double const cosine = sample_phase_cosine(drawn, std::max(1e-16, uniform(random)));
        ++hits.at(std::min(BINS - 1, static_cast<int>((cosine + 1) / 2 * BINS)));
    }
    ChiSquare sum;
    for (int i = 0; i < BINS; ++i) {
        double const mean = COUNT * share(expected, 2.0 * i / BINS - 1, 2.0 * (i + 1) / BINS - 1);
        sum.add(hits[i] - mean, mean);
    }
    --sum.degrees; // the counts have a fixed sum
    return sum;
}

} // namespace

TEST(ReferencePhase, integrates_to_one) {
    for (Phase const& phase : PHASES) EXPECT_NEAR(share(phase, -1, 1), 1, 1e-10) << name(phase);
}

TEST(ReferencePhase, values_are_the_formulas) {
    double const c = 0.3, pi = std::numbers::pi;
    EXPECT_DOUBLE_EQ(phase_value({Kind::isotropic}, c), 1 / (4 * pi));
    EXPECT_DOUBLE_EQ(phase_value({Kind::rayleigh}, c), 3 / (16 * pi) * 1.09);
    auto const lobe = [&](double g) { return (1 - g * g) / (4 * pi) / std::pow(1 + g * g - 2 * g * c, 1.5); };
    EXPECT_NEAR(phase_value({Kind::henyey_greenstein, 0.7}, c), lobe(0.7), 1e-14);
    EXPECT_NEAR(phase_value({Kind::double_henyey_greenstein, 0.8, -0.5, 0.3}, c), 0.7 * lobe(0.8) + 0.3 * lobe(-0.5),
                1e-14);
    EXPECT_NEAR(phase_value({Kind::cornette_shanks, 0.8}, c), 1.5 * 1.09 / (2 + 0.64) * lobe(0.8), 1e-14);
}

TEST(ReferencePhase, moments_are_the_closed_forms) {
    auto const mean = [](Phase const& phase) { return over_sphere(phase, -1, 1, [](double c) { return c; }); };
    EXPECT_NEAR(mean({Kind::henyey_greenstein, 0.76}), 0.76, 1e-9);
    EXPECT_NEAR(mean({Kind::double_henyey_greenstein, 0.8, -0.5, 0.3}), 0.7 * 0.8 - 0.3 * 0.5, 1e-9);
    // Cornette and Shanks 1992: <cos> = 3 g (4 + g^2) / (5 (2 + g^2)).
    EXPECT_NEAR(mean({Kind::cornette_shanks, 0.8}), 3 * 0.8 * 4.64 / (5 * 2.64), 1e-9);
    EXPECT_NEAR(over_sphere({Kind::rayleigh}, -1, 1, [](double c) { return c * c; }), 0.4, 1e-12);
}

TEST(ReferencePhase, sampled_cosines_invert_the_distribution) {
    for (Phase const& phase : PHASES) {
        if (phase.kind == Kind::double_henyey_greenstein) continue; // a mixture: its lobes take turns
        for (double const u : {1e-9, 1e-3, 0.1, 0.37, 0.5, 0.8, 0.999, 1 - 1e-9})
            EXPECT_NEAR(share(phase, -1, sample_phase_cosine(phase, u)), u, 2e-9) << name(phase) << ", u " << u;
    }
}

TEST(ReferencePhase, sampled_cosines_pass_chi_square) {
    for (Phase const& phase : PHASES) EXPECT_GT(compare(phase, phase).tail(), 1e-3) << name(phase);
}

TEST(ReferencePhase, chi_square_finds_a_lobe_one_percent_off) {
    EXPECT_LT(compare({Kind::cornette_shanks, 0.792}, {Kind::cornette_shanks, 0.8}).tail(), 1e-6);
    EXPECT_LT(compare({Kind::isotropic}, {Kind::rayleigh}).tail(), 1e-6);
}
