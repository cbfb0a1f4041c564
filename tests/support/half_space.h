#pragma once

#include "support/gauss_legendre.h"

namespace alpenglow::test {

/// Chandrasekhar's H function for isotropic scattering without absorption (Radiative Transfer, 1950, chapter V): the
/// solution of 1/H(mu) = 1/2 Int_0^1 x H(x) / (mu + x) dx.
class HFunction {
public:
    explicit HFunction(int n = 64) {
        // H bends like mu ln(mu) at 0: nodes even in the cube root of mu follow it.
        GaussLegendre const rule(n);
        for (GaussLegendre::Node const& node : rule.nodes()) {
            double const u = 0.5 * (node.x + 1);
            nodes_.push_back({u * u * u, 0.5 * node.weight * 3 * u * u, 1 + 2 * u * u * u});
        }
        for (double change = 1; change > 1e-14;) change = improve();
    }

    /// 0 <= mu <= 1.
    double operator()(double mu) const {
        return 2 / integral([mu](double x, double h) { return x * h / (mu + x); });
    }

    /// Int_0^1 mu^power H(mu) dmu.
    double moment(int power) const {
        return integral([power](double x, double h) { return std::pow(x, power) * h; });
    }

    /// Radiance that a half space reflects, per unit of the beam's irradiance on a plane across it [1/sr].
    /// Chandrasekhar lets a net flux pi F fall in and has I = F/4 mu0/(mu + mu0) H(mu) H(mu0); here F = 1/pi. Same in
    /// all azimuths.
    double reflected(double mu, double mu0) const {
        return 0.25 / std::numbers::pi * mu0 / (mu + mu0) * (*this)(mu) * (*this)(mu0);
    }

private:
    struct Node {
        double mu, weight, h;
    };

    template <typename F> double integral(F const& f) const {
        double sum = 0;
        for (Node const& node : nodes_) sum += node.weight * f(node.mu, node.h);
        return sum;
    }

    /// One round of iteration. The bare one swings around the solution; halving its steps damps that.
    double improve() {
        double change = 0;
        std::vector<Node> next = nodes_;
        for (Node& node : next) {
            double const h = 0.5 * (node.h + (*this)(node.mu));
            change = std::max(change, std::abs(h / node.h - 1));
            node.h = h;
        }
        nodes_ = next;
        return change;
    }

    std::vector<Node> nodes_;
};

} // namespace alpenglow::test
