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
    /// The density of a component, by the words of interop/atmosphere.h.
    double density(int i, double h) const {
        int ramp = 0;
        for (int j = 0; j < i; ++j) ramp += ramps(j);
        if (ramps(i) == 0) return std::exp(h * given.content.components[i].falloff);
        double sum = 0;
        for (int end = ramp + ramps(i); ramp < end; ++ramp)
            sum += given.content.ramps[ramp].z * std::clamp((h - given.content.ramps[ramp].x) * given.content.ramps[ramp].y, 0.0, 1.0);
        return sum;
    }
    dvec3 extinction(double h) const {
        dvec3 sum(0);
        for (int i = 0; code(i) != 0; ++i) sum += dvec3(given.content.components[i].extinction) * density(i, h);
        return sum;
    }
    /// Scattering times phase [1/(m sr)] at the cosine nu.
    dvec3 scattered(double h, double nu) const {
        dvec3 sum(0);
        for (int i = 0; code(i) != 0; ++i)
            sum += dvec3(given.content.components[i].scattering) * (density(i, h) * phase(given.content.components[i], nu));
        return sum;
    }

private:
    int code(int i) const {
        return i < AIR_COMPONENTS ? (given.content.composition[i / 4] >> (8 * (i % 4))) & 255 : 0;
    }
    int ramps(int i) const { return code(i) % 128 - 1; }
    static double lobe(glm::vec2 const& lobe, double nu) {
        double const g = lobe.x, alpha = lobe.y;
        return (1 - g * g) * (1 + alpha * nu * nu) / (1 + alpha * (1 + 2 * g * g) / 3) /
               (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * nu, 1.5));
    }
    static double phase(shader::AirComponent const& component, double nu) {
        double const share = component.second_share;
        return (1 - share) * lobe(component.first_lobe, nu) + share * lobe(component.second_lobe, nu);
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

/// Of the part of the sun's disc above the planet's edge, in slices; of its centre where it stands high.
inline dvec3 sun_transmittance(Air const& air, double h, double mu_s) {
    constexpr int SLICES = 12;
    constexpr double HIGH = 20;
    double const radius = air.given.sun_angular_radius, zenith = std::acos(std::clamp(mu_s, -1.0, 1.0));
    double const horizon = std::numbers::pi / 2 + std::acos(std::min(1.0, air.radius() / (air.radius() + h)));
    double const above = (horizon - zenith) / radius; // [radii]
    if (above <= -1) return dvec3(0);
    if (above > HIGH) return glm::exp(-optical_depth_to_top(air, h, mu_s));
    double const from = std::asin(std::max(-above, -1.0)), step = (std::numbers::pi / 2 - from) / SLICES;
    dvec3 sum(0);
    for (int i = 0; i < SLICES; ++i) {
        double const angle = from + (i + 0.5) * step, width = std::cos(angle);
        sum += width * width * step * glm::exp(-optical_depth_to_top(air, h, std::cos(zenith - radius * std::sin(angle))));
    }
    return sum * (2 / std::numbers::pi);
}

/// Single scattering between two distances [1/sr per unit of solar irradiance].
inline dvec3 single_scattering(Air const& air, Ray const& ray, double a, double b) {
    auto const at = cuts(ray, a, b);
    dvec3 sum(0), depth(0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        auto const extinction = [&](double t) { return air.extinction(ray.altitude(t)); };
        sum += gauss(
            [&](double t) {
                double const h = ray.altitude(t);
                dvec3 const sun = sun_transmittance(air, h, ray.mu_s(t));
                return air.scattered(h, ray.nu) * sun * glm::exp(-depth - gauss(extinction, at[i], t));
            },
            at[i], at[i + 1]);
        depth += gauss(extinction, at[i], at[i + 1]);
    }
    return sum;
}

} // namespace alpenglow::test::reference
