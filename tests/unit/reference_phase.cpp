#include "reference/phase.h"
#include "support/gauss_legendre.h"
#include "support/statistics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

using Kind = Phase::Kind;

PhaseLobes alone(double g, double alpha) { return {.first = {g, alpha}}; }

std::vector<PhaseLobes> const PHASES = {lobes_of({Kind::isotropic}),
                                        lobes_of({Kind::rayleigh}),
                                        alone(0, 20),
                                        alone(0.76, 0),
                                        alone(-0.4, 0),
                                        alone(0.95, 0),
                                        lobes_of({Kind::double_henyey_greenstein, 0.8, -0.5, 0.3}),
                                        alone(1e-3, 1),
                                        alone(0.8, 1),
                                        alone(-0.6, 1),
                                        alone(0.56, 22),
                                        lobes_of({Kind::droplets, 0, 0, 0, 5e-6})};

std::string name(PhaseLobes const& p) {
    return fmt::format("g {}, alpha {}, share {}", p.first.g, p.first.alpha, p.second_share);
}

/// Of the light, with cosines in [low, high].
double share(PhaseLobes const& phase, double low, double high) {
    static GaussLegendre const rule(24);
    double sum = 0;
    // Pieces halve towards both ends, where narrow lobes are.
    for (double width = 1; width > 1e-5; width /= 2)
        for (double const side : {-1.0, 1.0}) {
            double const inner = side * (1 - width), outer = side * (width > 2e-5 ? 1 - width / 2 : 1);
            double const a = std::max(low, std::min(inner, outer)), b = std::min(high, std::max(inner, outer));
            if (a < b) sum += rule.integrate(a, b, [&](double c) { return 2 * std::numbers::pi * phase_value(phase, c); });
        }
    return sum;
}

/// Chi-square of cosines drawn as `drawn`, binned, against the integrals of `expected`.
ChiSquare compare(PhaseLobes const& drawn, PhaseLobes const& expected) {
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

TEST(ReferencePhase, sampled_cosines_invert_the_distribution) {
    for (PhaseLobes const& phase : PHASES) {
        if (phase.second_share > 0) continue; // a mixture: its lobes take turns
        for (double const u : {1e-9, 1e-3, 0.1, 0.37, 0.5, 0.8, 0.999, 1 - 1e-9})
            EXPECT_NEAR(share(phase, -1, sample_phase_cosine(phase, u)), u, 2e-9) << name(phase) << ", u " << u;
    }
}

TEST(ReferencePhase, sampled_cosines_pass_chi_square) {
    for (PhaseLobes const& phase : PHASES) EXPECT_GT(compare(phase, phase).tail(), 1e-3) << name(phase);
}

TEST(ReferencePhase, chi_square_finds_a_lobe_one_percent_off) {
    EXPECT_LT(compare(alone(0.792, 1), alone(0.8, 1)).tail(), 1e-6);
    EXPECT_LT(compare(alone(0, 0), alone(0, 1)).tail(), 1e-6);
}
