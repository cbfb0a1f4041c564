#include "render/phase_moments.h"

#include <gtest/gtest.h>

using namespace alpenglow;

namespace {

using Kind = Phase::Kind;

PhaseLobes const AEROSOL = lobes_of({.kind = Kind::cornette_shanks, .g = 0.8});

} // namespace

TEST(PhaseMoments, of_light_that_turns_are_the_phases_own) {
    for (Phase const& phase : {Phase{.kind = Kind::isotropic}, Phase{.kind = Kind::rayleigh},
                               Phase{.kind = Kind::henyey_greenstein, .g = -0.8},
                               Phase{.kind = Kind::cornette_shanks, .g = -0.8}}) {
        EXPECT_EQ(straight_on_share(lobes_of(phase)), 0) << int(phase.kind);
        EXPECT_EQ(phase_moments(lobes_of(phase)).degree[0], 1) << int(phase.kind);
    }
    EXPECT_NEAR(phase_moments(lobes_of({.kind = Kind::rayleigh})).degree[2], 0.1, 1e-7);
}

// By quadrature, as they were when the share was chosen.
TEST(PhaseMoments, of_the_aerosol_lack_a_tenth) {
    float const expected[] = {0.8928f, 0.7370f, 0.6028f, 0.4702f, 0.3577f};
    for (int l = 0; l < PHASE_DEGREES; ++l)
        EXPECT_NEAR(phase_moments(AEROSOL).degree[l], expected[l], 1e-4) << l;
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
