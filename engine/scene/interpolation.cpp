#include "scene/interpolation.h"

#include <cmath>
#include <numbers>

namespace alpenglow::interpolation {

namespace {

/// A unit vector at a right angle to unit vector `a`, of no particular direction.
glm::dvec3 any_tangent(glm::dvec3 const& a) {
    glm::dvec3 const axis = std::abs(a.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(axis, a));
}

glm::dvec3 blend(glm::dvec3 const& a, glm::dvec3 const& b, double u) {
    return walk_great_circle(a, u * great_circle_step(a, b));
}

glm::dquat blend(glm::dquat const& a, glm::dquat const& b, double u) { return turned(a, u * turn_between(a, b)); }

/// De Casteljau's construction of the cubic Bezier curve, with slerps for straight lines.
template <typename Point> Point bezier(Point const& a, Point const& b, Point const& c, Point const& d, double u) {
    Point const ab = blend(a, b, u), bc = blend(b, c, u), cd = blend(c, d, u);
    return blend(blend(ab, bc, u), blend(bc, cd, u), u);
}

} // namespace

double monotone_rate(double before, double after) {
    return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

glm::dvec3 monotone_rate(glm::dvec3 const& before, glm::dvec3 const& after) {
    double const speed_before = glm::length(before), speed_after = glm::length(after);
    double const speed = monotone_rate(speed_before, speed_after);
    if (speed == 0) return glm::dvec3(0);
    return speed * 0.5 * (before / speed_before + after / speed_after);
}

double hermite(double a, double slope_a, double slope_b, double b, double u) {
    double const v = 1 - u;
    return a + u * u * (3 - 2 * u) * (b - a) + u * v * (v * slope_a - u * slope_b);
}

glm::dvec3 great_circle_step(glm::dvec3 const& a, glm::dvec3 const& b) {
    // The part of b at a right angle to a, from products that keep small angles.
    glm::dvec3 const tangent = glm::cross(glm::cross(a, b), a);
    double const sine = glm::length(tangent), cosine = glm::dot(a, b);
    if (sine == 0) return cosine > 0 ? glm::dvec3(0) : std::numbers::pi * any_tangent(a);
    return std::atan2(sine, cosine) / sine * tangent;
}

glm::dvec3 walk_great_circle(glm::dvec3 const& a, glm::dvec3 const& step) {
    double const angle = glm::length(step);
    if (angle == 0) return a;
    return glm::normalize(std::cos(angle) * a + std::sin(angle) / angle * step);
}

glm::dvec3 carry(glm::dvec3 const& vector, glm::dvec3 const& from, glm::dvec3 const& to) {
    glm::dvec3 const turn = glm::cross(from, great_circle_step(from, to));
    return turned(glm::dquat(1, 0, 0, 0), turn) * vector;
}

glm::dvec3 turn_between(glm::dquat const& a, glm::dquat const& b) {
    glm::dquat turn = b * glm::conjugate(a);
    if (turn.w < 0) turn = -turn;
    glm::dvec3 const axis(turn.x, turn.y, turn.z);
    double const sine = glm::length(axis);
    return sine == 0 ? glm::dvec3(0) : 2 * std::atan2(sine, turn.w) / sine * axis;
}

glm::dquat turned(glm::dquat const& a, glm::dvec3 const& turn) {
    double const angle = glm::length(turn);
    if (angle == 0) return a;
    return glm::normalize(glm::angleAxis(angle, turn / angle) * a);
}

glm::dvec3 hermite(glm::dvec3 const& a, glm::dvec3 const& slope_a, glm::dvec3 const& slope_b, glm::dvec3 const& b,
                   double u) {
    return bezier(a, walk_great_circle(a, slope_a / 3.0), walk_great_circle(b, -slope_b / 3.0), b, u);
}

glm::dquat hermite(glm::dquat const& a, glm::dvec3 const& slope_a, glm::dvec3 const& slope_b, glm::dquat const& b,
                   double u) {
    return bezier(a, turned(a, slope_a / 3.0), turned(b, -slope_b / 3.0), b, u);
}

} // namespace alpenglow::interpolation
