#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

/// Curves through values given at times, each with a continuous derivative and without overshoot. Directions and
/// rotations follow cubic Bezier curves made of slerps (K. Shoemake, Animating Rotation with Quaternion Curves, 1985);
/// their tangents are the vector form of the monotone rule for numbers.
namespace alpenglow::interpolation {

/// The rate at a key between the mean rates of its two neighbouring segments, such that the cubic between keys is
/// monotone: their harmonic mean, 0 at an extreme (F. N. Fritsch and J. Butland, 1984, with equal weights).
double monotone_rate(double before, double after);
/// The same for velocities: for parallel ones as for numbers, 0 for opposite ones, and the mean direction between.
glm::dvec3 monotone_rate(glm::dvec3 const& before, glm::dvec3 const& after);

/// Cubic Hermite at `u` in 0 to 1 from `a` to `b`; the slopes are per unit of u.
double hermite(double a, double slope_a, double slope_b, double b, double u);

/// The tangent vector at unit vector `a` that leads to `b` along the great circle; its length is the angle [rad].
glm::dvec3 great_circle_step(glm::dvec3 const& a, glm::dvec3 const& b);
/// The end of that walk; the inverse of great_circle_step.
glm::dvec3 walk_great_circle(glm::dvec3 const& a, glm::dvec3 const& step);
/// A vector carried along by the smallest rotation that takes unit vector `from` to `to`.
glm::dvec3 carry(glm::dvec3 const& vector, glm::dvec3 const& from, glm::dvec3 const& to);
/// The rotation vector [rad] of the shorter turn from `a` to `b`, in the outer frame: b = turned(a, turn_between(a,
/// b)).
glm::dvec3 turn_between(glm::dquat const& a, glm::dquat const& b);
glm::dquat turned(glm::dquat const& a, glm::dvec3 const& turn);

/// As hermite, on the sphere and among rotations; slopes are tangent and rotation vectors per unit of u.
glm::dvec3 hermite(glm::dvec3 const& a, glm::dvec3 const& slope_a, glm::dvec3 const& slope_b, glm::dvec3 const& b,
                   double u);
glm::dquat hermite(glm::dquat const& a, glm::dvec3 const& slope_a, glm::dvec3 const& slope_b, glm::dquat const& b,
                   double u);

} // namespace alpenglow::interpolation
