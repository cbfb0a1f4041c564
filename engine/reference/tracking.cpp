#include "reference/tracking.h"

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
        shells_.push_back({medium.radius + top, largest_extinction(medium, bottom, top)});
        bottom = top;
    }
}

std::size_t Tracking::shell_at(double radius) const {
    auto const above = std::ranges::upper_bound(shells_, radius, {}, &Shell::top_radius);
    return above == shells_.end() ? shells_.size() - 1 : static_cast<std::size_t>(above - shells_.begin());
}

std::optional<double> Tracking::fly(Ray const& ray, double from, double to, int channel, PathNumbers& numbers) const {
    if (shells_.empty()) return std::nullopt;
    std::size_t shell = shell_at(ray.radius_at(from));
    double at = from, depth = -std::log(numbers.next());
    while (at < to) {
        // Where the ray leaves the shell: down through its bottom, or up through its top.
        double leave = to;
        std::size_t next = shell;
        double const bottom_squared = shell > 0 ? shells_[shell - 1].top_radius * shells_[shell - 1].top_radius : 0;
        if (ray.along + at < 0 && shell > 0 && ray.closest_squared < bottom_squared) {
            leave = -ray.along - std::sqrt(bottom_squared - ray.closest_squared);
            next = shell - 1;
        } else if (shell + 1 < shells_.size()) {
            double const top = shells_[shell].top_radius;
            leave = -ray.along + std::sqrt(std::max(0.0, top * top - ray.closest_squared));
            next = shell + 1;
        }
        double const end = std::min(leave, to), majorant = shells_[shell].majorant[channel];
        while (depth < majorant * (end - at)) {
            at += depth / majorant;
            double const real = medium_.extinction(ray.radius_at(at) - medium_.radius)[channel];
            if (numbers.independent() * majorant < real) return at;
            depth = -std::log(numbers.independent());
        }
        depth -= majorant * std::max(0.0, end - at);
        at = std::max(at, end);
        if (leave >= to) break;
        shell = next;
    }
    return std::nullopt;
}

} // namespace alpenglow
