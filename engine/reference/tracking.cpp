#include "reference/tracking.h"

#include "reference/shell_walk.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

glm::dvec3 largest_extinction(Medium const& medium, double lowest, double highest) {
    glm::dvec3 sum(0);
    for (Component const& component : medium.components) {
        sum += component.extinction * largest_density(component.profile, lowest, highest);
    }
    return sum;
}

bool within(glm::dvec3 const& larger, glm::dvec3 const& smaller, double ratio) {
    return larger.x <= ratio * smaller.x && larger.y <= ratio * smaller.y && larger.z <= ratio * smaller.z;
}

} // namespace

Tracking::Tracking(Medium const& medium) : medium_(medium) {
    constexpr int steps = 400;
    constexpr double ratio = 1.4;      // of the majorant to the least extinction in a shell; tuned for speed
    constexpr double negligible = 1e-4; // of the largest: there collisions are rare, real or not
    glm::dvec3 const all = largest_extinction(medium, 0, medium.top);
    double bottom = 0;
    for (int i = 1; i <= steps; ++i) {
        double const top = medium.top * i / steps, next = medium.top * std::min(i + 1, steps) / steps;
        glm::dvec3 const wider = largest_extinction(medium, bottom, next), outer = medium.extinction(next);
        bool const thin = within(wider, all, negligible);
        if (i < steps && (thin || within(wider, outer, ratio))) continue;
        top_radii_.push_back(medium.radius + top);
        majorants_.push_back(largest_extinction(medium, bottom, top));
        bottom = top;
    }
}

std::optional<double> Tracking::fly(Ray const& ray, double from, double to, int channel, PathNumbers& numbers) const {
    double depth = -std::log(numbers.next());
    for (ShellWalk walk(top_radii_, ray, from, to); walk.next();) {
        double const majorant = majorants_[walk.shell()][channel];
        double at = walk.begin();
        while (depth < majorant * (walk.end() - at)) {
            at += depth / majorant;
            double const real = medium_.extinction(ray.radius_at(at) - medium_.radius)[channel];
            if (numbers.independent() * majorant < real) return at;
            depth = -std::log(numbers.independent());
        }
        depth -= majorant * (walk.end() - at);
    }
    return std::nullopt;
}

} // namespace alpenglow
