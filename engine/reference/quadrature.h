#pragma once

#include <array>

namespace alpenglow {

/// The integral of f from a to b by the Gauss-Legendre rule of 16 points (Abramowitz and Stegun, table 25.4): exact for
/// polynomials of degree 31.
template <typename F> double gauss_legendre(F const& f, double a, double b) {
    constexpr std::array<double, 8> nodes{0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                          0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                          0.9445750230732326, 0.9894009349916499};
    constexpr std::array<double, 8> weights{0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                            0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                            0.0622535239386479, 0.0271524594117541};
    double const centre = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        sum += weights[i] * (f(centre - half * nodes[i]) + f(centre + half * nodes[i]));
    }
    return sum * half;
}

} // namespace alpenglow
