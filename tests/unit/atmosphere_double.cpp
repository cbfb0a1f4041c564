#include <gtest/gtest.h>

#include "support/air_in_double.h"

using namespace alpenglow::shader_double;

namespace {
constexpr double R = 6.36e6;
}

// In double the same text shows its formulas without rounding: whatever is left is a mistake. Literals, pi among them,
// stay float: 1e-7.
TEST(AirInDouble, the_text_compiles_and_its_geometry_is_exact) {
    for (double const mu : {-0.9, -0.2, -0.01, 0.0, 0.5, 1.0})
        for (double const t : {1.0, 1e4, 1e6}) {
            double const r = std::sqrt((R + 5000) * (R + 5000) + 2 * t * (R + 5000) * mu + t * t);
            EXPECT_NEAR(altitude_at(make_air_ray(R, 5000, mu, 0, 0), t), r - R, 1e-6) << mu << " " << t;
        }
}

TEST(AirInDouble, the_helpers_are_exact) {
    for (double const x : {1e-6, 0.01, 0.1249, 0.126, 3.0}) {
        EXPECT_NEAR(mean_transmittance(x), -std::expm1(-x) / x, 1e-7) << x;
        EXPECT_NEAR(minus_log_one_minus(x / 4), -std::log1p(-x / 4), 1e-7 * x) << x;
    }
}

TEST(AirInDouble, the_zeniths_optical_depth_is_the_closed_form) {
    Atmosphere air{};
    air.ground_radius = R;
    air.top_altitude = 1e5;
    air.content.components[0].extinction = glm::dvec3(33.1e-6);
    air.content.components[0].falloff = -1.0 / 8000;
    air.content.components[1].extinction = glm::dvec3(4.44e-6);
    air.content.components[1].falloff = -1.0 / 1200;
    air.content.components[2].extinction = glm::dvec3(1.881e-6);
    air.content.ramps[0] = {10000, 1.0 / 15000, 1};
    air.content.ramps[1] = {25000, 1.0 / 15000, -1};
    air.content.composition.x = air_component_code(0, false) | air_component_code(0, false) << 8 | air_component_code(2, false) << 16;
    double const exact = 33.1e-6 * 8000 * -std::expm1(-12.5) + 4.44e-6 * 1200 + 1.881e-6 * 15000;
    // What 120 Gauss-Legendre nodes leave.
    EXPECT_NEAR(compute_optical_depth_to_top(air, 0, 1).x, exact, 1e-6 * exact);
}

TEST(AirInDouble, measure_and_distance_are_inverse) {
    Atmosphere air{};
    air.top_altitude = 1e5;
    for (double const mu : {-0.9, -0.01, 0.0, 0.1, 1.0}) {
        MarchCells const cells = make_march_cells(air, make_air_ray(R, 5000, mu, 0, 0), 0, 5000);
        for (double const travel : {1.0, 100.0, 4000.0})
            EXPECT_NEAR(travel_from_measure(cells, measure_from_travel(cells, travel)), travel, 1e-6 * travel) << mu;
    }
}
