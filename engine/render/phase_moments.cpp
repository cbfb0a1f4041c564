#include "render/phase_moments.h"

#include <array>
#include <cmath>
#include <numbers>

namespace alpenglow {

namespace {

constexpr std::size_t STRAIGHT_ON_DEGREE = 10;
constexpr int STEPS = 4000;

} // namespace

double rayleigh_phase(double cosine) { return 3 / (16 * std::numbers::pi) * (1 + cosine * cosine); }

double cornette_shanks_phase(double cosine, double g) {
    return 3 * (1 - g * g) * (1 + cosine * cosine) /
           (8 * std::numbers::pi * (2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

shader::PhaseMoments phase_moments(PhaseFunction const& phase) {
    std::array<double, STRAIGHT_ON_DEGREE + 1> degree{};
    for (int i = 0; i < STEPS; ++i) {
        // angle = pi u²: dense around the forward peak
        double const u = (i + 0.5) / STEPS, angle = std::numbers::pi * u * u, x = std::cos(angle);
        double const solid_angle = 2 * std::numbers::pi * std::sin(angle) * 2 * std::numbers::pi * u / STEPS;
        double const share = phase(x) * solid_angle;
        double value = 1, next = x;
        for (double l = 0; double& coefficient : degree) {
            coefficient += share * value;
            double const after = ((2 * l + 3) * x * next - (l + 1) * value) / (l + 2);
            value = next, next = after, l += 1;
        }
    }
    shader::PhaseMoments moments{};
    for (std::size_t l = 0; l < PHASE_DEGREES; ++l)
        moments.degree[l] = static_cast<float>(degree[l] - degree[STRAIGHT_ON_DEGREE]);
    return moments;
}

} // namespace alpenglow
