#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace alpenglow {

/// A ray around a planet whose centre is the origin. `direction` is a unit vector; distances in m.
struct Ray {
    glm::dvec3 origin, direction;
    double along;            ///< distance from the closest approach to the planet's centre; negative on the way in
    double closest_squared;  ///< of that approach [m^2]

    Ray(glm::dvec3 const& o, glm::dvec3 const& d) : origin(o), direction(d), along(dot(o, d)) {
        // |o x d|^2 does not cancel where the ray passes the centre closely.
        glm::dvec3 const moment = cross(o, d);
        closest_squared = dot(moment, moment);
    }

    glm::dvec3 at(double distance) const { return origin + distance * direction; }
    double radius_at(double distance) const {
        return std::sqrt(closest_squared + (along + distance) * (along + distance));
    }
    /// Cosine between the direction and the zenith.
    double mu_at(double distance) const { return (along + distance) / radius_at(distance); }
};

/// Where a ray is inside a sphere around the planet's centre: `in` may be negative; empty where out <= in.
struct Span {
    double in = 0, out = 0;

    bool empty() const { return !(out > in); }
};

inline Span span_inside(Ray const& ray, double radius) {
    double const half_squared = radius * radius - ray.closest_squared;
    if (half_squared <= 0) return {};
    double const half = std::sqrt(half_squared);
    return {-ray.along - half, -ray.along + half};
}

/// Two unit vectors that stand upright on a unit vector and on each other (Duff et al. 2017).
inline void make_basis(glm::dvec3 const& n, glm::dvec3& b1, glm::dvec3& b2) {
    double const sign = std::copysign(1.0, n.z);
    double const a = -1 / (sign + n.z), b = n.x * n.y * a;
    b1 = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    b2 = {b, sign + n.y * n.y * a, -n.y};
}

/// The unit vector at this cosine from `axis`, turned around it by `turn` of a full circle.
inline glm::dvec3 around(glm::dvec3 const& axis, double cosine, double turn) {
    glm::dvec3 b1, b2;
    make_basis(axis, b1, b2);
    double const sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), phi = 2 * M_PI * turn;
    return normalize(axis * cosine + (b1 * std::cos(phi) + b2 * std::sin(phi)) * sine);
}

} // namespace alpenglow
