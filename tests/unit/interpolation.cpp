#include "scene/interpolation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace alpenglow::interpolation;

TEST(Interpolation, monotone_rates_lie_between_their_neighbours_and_stop_at_an_extreme) {
    EXPECT_DOUBLE_EQ(monotone_rate(3.0, 3.0), 3);
    EXPECT_DOUBLE_EQ(monotone_rate(1.0, 3.0), 1.5);
    EXPECT_EQ(monotone_rate(1.0, -3.0), 0);
    EXPECT_EQ(monotone_rate(0.0, 3.0), 0);
    glm::dvec3 const x(1, 0, 0), y(0, 1, 0);
    EXPECT_EQ(monotone_rate(x, 3.0 * x), 1.5 * x); // as for numbers
    EXPECT_EQ(monotone_rate(x, -3.0 * x), glm::dvec3(0));
    EXPECT_EQ(monotone_rate(x, y), 0.5 * (x + y));
}

TEST(Interpolation, hermite_has_the_ends_and_slopes_that_it_is_given) {
    constexpr double D = 1e-6; // difference quotients are good to about D
    EXPECT_DOUBLE_EQ(hermite(2.0, 3.0, -1.0, 5.0, 0), 2);
    EXPECT_DOUBLE_EQ(hermite(2.0, 3.0, -1.0, 5.0, 1), 5);
    EXPECT_NEAR((hermite(2.0, 3.0, -1.0, 5.0, D) - 2) / D, 3, 20 * D);
    EXPECT_NEAR((5 - hermite(2.0, 3.0, -1.0, 5.0, 1 - D)) / D, -1, 20 * D);
    glm::dvec3 const a(1, 0, 0), b = glm::normalize(glm::dvec3(0.6, 0.7, 0.1)), slope_a(0, 0.3, 0.4);
    glm::dvec3 const slope_b = glm::cross(b, glm::dvec3(0.2, -0.1, 0.3));
    EXPECT_LT(glm::length((hermite(a, slope_a, slope_b, b, D) - a) / D - slope_a), 20 * D);
    EXPECT_LT(glm::length((b - hermite(a, slope_a, slope_b, b, 1 - D)) / D - slope_b), 20 * D);
    glm::dquat const p(1, 0, 0, 0), q = glm::angleAxis(1.2, glm::normalize(glm::dvec3(1, 2, 3)));
    EXPECT_LT(glm::length(turn_between(p, hermite(p, slope_a, slope_b, q, D)) / D - slope_a), 20 * D);
    EXPECT_LT(glm::length(turn_between(hermite(p, slope_a, slope_b, q, 1 - D), q) / D - slope_b), 20 * D);
}

TEST(Interpolation, a_walk_undoes_a_step_for_any_angle) {
    glm::dvec3 const a = glm::normalize(glm::dvec3(0.3, -0.5, 0.8)), side = glm::normalize(glm::cross(a, glm::dvec3(1, 1, 1)));
    for (double const angle : {0.0, 1e-12, 1e-6, 0.5, 3.0, std::numbers::pi}) {
        glm::dvec3 const b = std::cos(angle) * a + std::sin(angle) * side;
        EXPECT_NEAR(glm::length(great_circle_step(a, b)), angle, 1e-15 + 1e-9 * (angle > 3.1));
        EXPECT_LT(glm::length(walk_great_circle(a, great_circle_step(a, b)) - b), 1e-9);
        EXPECT_LT(glm::length(carry(a, a, b) - b), 1e-9);
    }
}

TEST(Interpolation, turns_take_the_short_way) {
    glm::dquat const a = glm::angleAxis(3.0, glm::dvec3(0, 0, 1)), b = glm::angleAxis(-3.0, glm::dvec3(0, 0, 1));
    EXPECT_NEAR(glm::length(turn_between(a, b)), 2 * std::numbers::pi - 6, 1e-14);
    EXPECT_NEAR(std::abs(glm::dot(turned(a, turn_between(a, b)), b)), 1, 1e-14);
    EXPECT_EQ(turn_between(a, -a), glm::dvec3(0)); // one rotation, two quaternions
}
