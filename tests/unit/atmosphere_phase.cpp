#include "atmosphere/phase.glsl"
#include "scene/phase.h"

#include <gtest/gtest.h>

using namespace alpenglow::shader;
using alpenglow::Phase;
using alpenglow::PhaseLobes;

namespace {

using Kind = Phase::Kind;

template <typename F> double over_sphere(F const& phase) {
    int const n = 200'000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += phase(float(-1 + (2 * i + 1.0) / n));
    return sum / n * 4 * 3.14159265358979;
}

AirComponent component(PhaseLobes const& lobes) {
    AirComponent result{};
    result.first_lobe = vec2(lobes.first.g, lobes.first.alpha);
    result.second_lobe = vec2(lobes.second.g, lobes.second.alpha);
    result.second_share = float(lobes.second_share);
    return result;
}

} // namespace

TEST(Phases, integrate_to_one_over_the_sphere) {
    // The midpoint rule on the sharpest peak (g = 0.95) is exact to 1e-6; float rounding of each value adds 1e-7.
    EXPECT_NEAR(over_sphere([](float) { return ISOTROPIC_PHASE; }), 1, 1e-6);
    for (float const g : {-0.9f, -0.3f, 0.0f, 0.5f, 0.76f, 0.8f, 0.95f})
        for (float const alpha : {0.0f, 1.0f, 20.0f})
            EXPECT_NEAR(over_sphere([=](float nu) { return draine_phase(nu, g, alpha); }), 1, 1e-5)
                << g << " " << alpha;
}

TEST(Phases, are_those_of_the_scene) {
    for (Phase const& phase : {Phase{},
                               {Kind::rayleigh},
                               {Kind::henyey_greenstein, -0.3},
                               {Kind::cornette_shanks, 0.8},
                               {Kind::double_henyey_greenstein, 0.8, -0.5, 0.3},
                               {Kind::droplets, 0, 0, 0, 2e-5}}) {
        PhaseLobes const lobes = lobes_of(phase);
        for (float const nu : {-1.0f, -0.5f, 0.0f, 0.4f, 0.99f, 1.0f}) {
            double const exact = phase_value(lobes, nu);
            // (1 - g) of a droplet's peak, 0.005, is known to 1e-5 in float; its cube counts.
            EXPECT_NEAR(component_phase(component(lobes), nu), exact, 1e-4 * exact) << int(phase.kind) << " " << nu;
        }
    }
}

TEST(Phases, the_aerosols_peak_surrounds_the_sun) {
    EXPECT_GT(draine_phase(1, 0.8f, 1), 100 * draine_phase(0, 0.8f, 1));
    EXPECT_GT(draine_phase(1, 0.8f, 1), 100 * draine_phase(-1, 0.8f, 1));
}
