#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace alpenglow::test {

/// The rule of Gauss and Legendre, exact for polynomials of degree 2n - 1.
class GaussLegendre {
public:
    explicit GaussLegendre(int n) {
        for (int i = 0; i < n; ++i) {
            double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
            Legendre p = legendre(n, x);
            for (int round = 0; round < 8; ++round) x -= p.value / p.slope, p = legendre(n, x);
            nodes_.push_back({x, 2 / ((1 - x * x) * p.slope * p.slope)});
        }
    }

    /// The integral of f, a function of a double, over [a, b].
    template <typename F> auto integrate(double a, double b, F const& f) const {
        double const middle = 0.5 * (a + b), half = 0.5 * (b - a);
        auto sum = half * nodes_.front().weight * f(middle + half * nodes_.front().x);
        for (std::size_t i = 1; i < nodes_.size(); ++i) sum += half * nodes_[i].weight * f(middle + half * nodes_[i].x);
        return sum;
    }

    struct Node {
        double x, weight; ///< on [-1, 1]
    };
    std::vector<Node> const& nodes() const { return nodes_; }

private:
    struct Legendre {
        double value, slope;
    };
    /// The Legendre polynomial of degree n >= 1, |x| < 1.
    static Legendre legendre(int n, double x) {
        double before = 1, value = x;
        for (int k = 2; k <= n; ++k) {
            double const next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
            before = value, value = next;
        }
        return {value, n * (x * value - before) / (x * x - 1)};
    }

    std::vector<Node> nodes_;
};

} // namespace alpenglow::test
