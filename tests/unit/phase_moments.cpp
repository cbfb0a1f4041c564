#include "render/phase_moments.h"

#include "support/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace alpenglow;

namespace {

using Kind = Phase::Kind;

PhaseLobes const AEROSOL = lobes_of({.kind = Kind::cornette_shanks, .g = 0.8});

} // namespace

TEST(PhaseMoments, of_light_that_turns_are_the_phases_own) {
    for (Phase const& phase :
         {Phase{.kind = Kind::isotropic}, Phase{.kind = Kind::rayleigh},
          Phase{.kind = Kind::henyey_greenstein, .g = -0.8}, Phase{.kind = Kind::cornette_shanks, .g = -0.8}}) {
        EXPECT_EQ(straight_on_share(lobes_of(phase)), 0) << int(phase.kind);
        EXPECT_EQ(phase_moments(lobes_of(phase)).degree[0], 1) << int(phase.kind);
    }
    EXPECT_NEAR(phase_moments(lobes_of({.kind = Kind::rayleigh})).degree[2], 0.1, 1e-7);
}

// For which the share was chosen.
TEST(PhaseMoments, of_the_aerosol_lack_its_tenth_degree) {
    test::GaussLegendre const rule(60); // exact to 1e-9 for a peak of g = 0.8
    auto const coefficient = [&](unsigned l) {
        return rule.integrate(
            -1, 1, [&](double x) { return 2 * std::numbers::pi * phase_value(AEROSOL, x) * std::legendre(l, x); });
    };
    EXPECT_NEAR(straight_on_share(AEROSOL), coefficient(10), 1e-6);
    for (unsigned l = 0; l < PHASE_DEGREES; ++l)
        EXPECT_NEAR(phase_moments(AEROSOL).degree[l], coefficient(l) - coefficient(10), 1e-6) << l;
}

// More light goes straight on the narrower the peak is, and never all of it.
TEST(PhaseMoments, share_grows_with_the_peak) {
    double last = 0;
    for (double const g : {0.3, 0.6, 0.8, 0.9, 0.99}) {
        double const share = straight_on_share(lobes_of({.kind = Kind::henyey_greenstein, .g = g}));
        EXPECT_GT(share, last);
        EXPECT_LT(share, 1);
        last = share;
    }
    double const droplets = straight_on_share(lobes_of({.kind = Kind::droplets, .diameter = 2e-5}));
    EXPECT_GT(droplets, straight_on_share(AEROSOL));
    EXPECT_LT(droplets, 1);
}
