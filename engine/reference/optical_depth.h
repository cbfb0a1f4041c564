#pragma once

#include "reference/chapman_table.h"
#include "reference/medium.h"
#include "reference/ray.h"

#include <optional>

namespace alpenglow {

/// Optical depth of a medium along straight rays, in double precision: Chapman's function from a table for exponential
/// profiles, closed forms for linear ones. Within 1e-6 of quadrature (tests/unit/reference_depth.cpp), so that
/// transmittance is too, relatively.
class OpticalDepth {
public:
    explicit OpticalDepth(Medium const& medium);

    /// From a place at `radius` [m] inside the medium to its top, mu >= 0.
    glm::dvec3 climbing(double radius, double mu) const { return rising(radius, mu) - above_top(radius, mu); }
    /// The same with what exponential profiles would hold above the top: along one ray the differences are right.
    glm::dvec3 rising(double radius, double mu) const;
    /// From a place to the medium's top in a direction that misses the planet: mu may be negative.
    glm::dvec3 to_top(double radius, double mu) const;
    double planet_radius() const { return radius_; }

private:
    struct ExponentialPart {
        glm::dvec3 extinction; ///< [1/m] at altitude 0
        double scale_height;
        double top_density;
        ChapmanTable table;
    };
    struct LinearPart {
        glm::dvec3 extinction;
        LinearProfile profile;
    };
    glm::dvec3 above_top(double radius, double mu) const;
    void add(glm::dvec3& sum, LinearPart const& part, double radius, double mu) const;

    double radius_, top_radius_;
    std::vector<ExponentialPart> exponential_;
    std::vector<LinearPart> linear_;
};

/// Optical depth along one ray, from a fixed place on it: what lies between two distances is the difference of two
/// values. Both distances must be inside the medium, and the planet not between them.
class DepthAlong {
public:
    DepthAlong(OpticalDepth const& depth, Ray const& ray);

    glm::dvec3 at(double distance) const;

private:
    OpticalDepth const* depth_;
    Ray const* ray_;
    mutable std::optional<glm::dvec3> inward_; ///< twice `rising` from the closest approach, once it is asked for
};

} // namespace alpenglow
