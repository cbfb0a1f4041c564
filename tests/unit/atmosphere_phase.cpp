#include "atmosphere/phase.glsl"

#include <gtest/gtest.h>

using namespace alpenglow::shader;

namespace {
template <typename Phase> double over_sphere(Phase const& phase) {
    int const n = 200'000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += phase(float(-1 + (2 * i + 1.0) / n));
    return sum / n * 4 * 3.14159265358979;
}
} // namespace

TEST(Phases, integrate_to_one_over_the_sphere) {
    // The midpoint rule on the sharpest peak (g = 0.95) is exact to 1e-6; float rounding of each value adds 1e-7.
    EXPECT_NEAR(over_sphere(rayleigh_phase), 1, 1e-5);
    EXPECT_NEAR(over_sphere([](float) { return ISOTROPIC_PHASE; }), 1, 1e-6);
    for (float const g : {-0.9f, -0.3f, 0.0f, 0.5f, 0.76f, 0.8f, 0.95f}) {
        EXPECT_NEAR(over_sphere([g](float nu) { return henyey_greenstein_phase(nu, g); }), 1, 1e-5) << g;
        EXPECT_NEAR(over_sphere([g](float nu) { return cornette_shanks_phase(nu, g); }), 1, 1e-5) << g;
    }
}

TEST(Phases, the_aerosols_peak_surrounds_the_sun) {
    EXPECT_GT(cornette_shanks_phase(1, 0.8f), 100 * cornette_shanks_phase(0, 0.8f));
    EXPECT_GT(cornette_shanks_phase(1, 0.8f), 100 * cornette_shanks_phase(-1, 0.8f));
    EXPECT_EQ(rayleigh_phase(1), rayleigh_phase(-1));
}

TEST(Phases, cornette_and_shanks_without_asymmetry_is_rayleighs) {
    for (float const nu : {-1.0f, -0.4f, 0.0f, 0.7f, 1.0f})
        EXPECT_FLOAT_EQ(cornette_shanks_phase(nu, 0), rayleigh_phase(nu));
}
