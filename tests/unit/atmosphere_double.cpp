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
