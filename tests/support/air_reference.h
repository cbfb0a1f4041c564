#pragma once

#include "interop/atmosphere.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// The equations once more, in double precision and by brute force; shares nothing with `shaders/atmosphere`.
namespace alpenglow::test::reference {

using glm::dvec3;

struct Air {
    explicit Air(shader::Atmosphere const& air) : given(air) {}
    shader::Atmosphere given;
    double radius() const { return given.ground_radius; }
    double top() const { return given.top_altitude; }
    double rayleigh(double h) const { return std::exp(-h / given.rayleigh_scale_height); }
    double aerosol(double h) const { return std::exp(-h / given.aerosol_scale_height); }
    double ozone(double h) const {
        return std::max(0.0, 1 - std::abs(h - given.ozone_centre) / double(given.ozone_half_width));
    }
    dvec3 extinction(double h) const {
        return dvec3(given.rayleigh_scattering) * rayleigh(h) + dvec3(given.aerosol_extinction) * aerosol(h) +
               dvec3(given.ozone_absorption) * ozone(h);
    }
};

/// A ray in the plane of the zenith, by its origin's altitude [m] and cosines.
struct Ray {
    double radius, h0, mu0, mu_s0 = 1, nu = 1;
    double r0() const { return radius + h0; }
    double r(double t) const {
        return double(std::sqrt((long double)r0() * r0() + 2.0L * t * r0() * mu0 + (long double)t * t));
    }
    double altitude(double t) const {
        return double(std::sqrt((long double)r0() * r0() + 2.0L * t * r0() * mu0 + (long double)t * t) - radius);
    }
    double mu(double t) const { return (r0() * mu0 + t) / r(t); }
    double mu_s(double t) const { return (r0() * mu_s0 + t * nu) / r(t); }
    /// Distances to the sphere at altitude h, both signs; NaN where the ray misses it.
    std::array<double, 2> crossings(double h) const {
        double const b = r0() * mu0, root = std::sqrt(b * b - r0() * r0() + (radius + h) * (radius + h));
        return {-b - root, -b + root};
    }
};

/// The integral of f over [a, b] by five Gauss-Legendre nodes.
template <typename F> auto gauss(F const& f, double a, double b) {
    double const m = 0.5 * (a + b), half = 0.5 * (b - a);
    double const x1 = 0.538469310105683 * half, x2 = 0.906179845938664 * half;
    return half * (0.568888888888889 * f(m) + 0.478628670499366 * (f(m - x1) + f(m + x1)) +
                   0.236926885056189 * (f(m - x2) + f(m + x2)));
}

/// Distances that cut [a, b] of a ray wherever it crosses a shell of the air, the ozone's kinks among them, and at its
/// lowest point.
inline std::vector<double> cuts(Ray const& ray, double a, double b) {
    std::vector<double> at{a, b, std::clamp(-ray.r0() * ray.mu0, a, b)};
    for (double h = 0; h <= 1e5; h += h < 5e3 ? 500 : h < 4e4 ? 1000 : 5000)
        for (double const t : ray.crossings(h))
            if (t > a && t < b) at.push_back(t);
    std::sort(at.begin(), at.end());
    return at;
}

inline dvec3 optical_depth(Air const& air, Ray const& ray, double a, double b) {
    auto const at = cuts(ray, a, b);
    dvec3 sum(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
        sum += gauss([&](double t) { return air.extinction(ray.altitude(t)); }, at[i], at[i + 1]);
    return sum;
}

inline dvec3 optical_depth_to_top(Air const& air, double h, double mu) {
    Ray const ray{air.radius(), h, mu};
    return optical_depth(air, ray, 0, std::max(0.0, ray.crossings(air.top())[1]));
}

/// The share of a disc above a line x radii below its centre.
inline double disc_share(double x) {
    x = std::clamp(x, -1.0, 1.0);
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
}

inline dvec3 sun_transmittance(Air const& air, double h, double mu_s) {
    double const horizon = std::numbers::pi / 2 + std::acos(std::min(1.0, air.radius() / (air.radius() + h)));
    double const above = disc_share((horizon - std::acos(std::clamp(mu_s, -1.0, 1.0))) / air.given.sun_angular_radius);
    if (above == 0) return dvec3(0);
    return glm::exp(-optical_depth_to_top(air, h, std::max(mu_s, std::cos(horizon)))) * above;
}

inline double rayleigh_phase(double nu) { return 3 / (16 * std::numbers::pi) * (1 + nu * nu); }
inline double cornette_shanks_phase(double nu, double g) {
    return 3 / (8 * std::numbers::pi) * (1 - g * g) * (1 + nu * nu) /
           ((2 + g * g) * std::pow(1 + g * g - 2 * g * nu, 1.5));
}

/// Single scattering between two distances [1/sr per unit of solar irradiance].
inline dvec3 single_scattering(Air const& air, Ray const& ray, double a, double b) {
    double const rayleigh = rayleigh_phase(ray.nu), aerosol = cornette_shanks_phase(ray.nu, air.given.aerosol_g);
    auto const at = cuts(ray, a, b);
    dvec3 sum(0), depth(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        auto const extinction = [&](double t) { return air.extinction(ray.altitude(t)); };
        sum += gauss(
            [&](double t) {
                double const h = ray.altitude(t);
                dvec3 const source = dvec3(air.given.rayleigh_scattering) * (air.rayleigh(h) * rayleigh) +
                                     dvec3(air.given.aerosol_scattering) * (air.aerosol(h) * aerosol);
                return source * sun_transmittance(air, h, ray.mu_s(t)) * glm::exp(-depth - gauss(extinction, at[i], t));
            },
            at[i], at[i + 1]);
        depth += gauss(extinction, at[i], at[i + 1]);
    }
    return sum;
}

} // namespace alpenglow::test::reference
