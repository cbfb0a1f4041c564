#include "reference/optical_depth.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

OpticalDepth::OpticalDepth(Medium const& medium) : radius_(medium.radius), top_radius_(medium.top_radius()) {
    for (Component const& component : medium.components) {
        if (auto const* const profile = std::get_if<ExponentialProfile>(&component.profile)) {
            double const height = profile->scale_height;
            exponential_.push_back({component.extinction, height, std::exp(-medium.top / height),
                                    ChapmanTable(radius_, top_radius_, height)});
        } else {
            linear_.push_back({component.extinction, std::get<LinearProfile>(component.profile)});
        }
    }
}

/// In each layer the density is d0 + slope (r - r0), r = sqrt(p^2 + s^2), s from the closest approach p:
/// the integral of r ds is (s r + p^2 log(s + r)) / 2.
void OpticalDepth::add(glm::dvec3& sum, LinearPart const& part, double radius, double mu) const {
    auto const& nodes = part.profile.nodes;
    double const p_squared = radius * radius * std::max(0.0, 1 - mu * mu);
    auto const distance_at = [&](double r) { return std::sqrt(std::max(0.0, r * r - p_squared)); };
    double path = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        double const low = std::max(radius_ + nodes[i - 1].altitude, radius);
        double const high = std::min(radius_ + nodes[i].altitude, top_radius_);
        if (high <= low) continue;
        double const rise = nodes[i].density - nodes[i - 1].density;
        double const s0 = low == radius ? radius * mu : distance_at(low), s1 = distance_at(high);
        path += nodes[i - 1].density * (s1 - s0);
        if (rise == 0) continue;
        double const slope = rise / (nodes[i].altitude - nodes[i - 1].altitude);
        double const radii = 0.5 * (s1 * high - s0 * low + p_squared * std::log((s1 + high) / (s0 + low)));
        path += slope * (radii - (radius_ + nodes[i - 1].altitude) * (s1 - s0));
    }
    sum += part.extinction * path;
}

glm::dvec3 OpticalDepth::rising(double radius, double mu) const {
    glm::dvec3 sum(0);
    for (ExponentialPart const& part : exponential_) {
        sum += part.extinction * (std::exp((radius_ - radius) / part.scale_height) * part.table.path(radius, mu));
    }
    for (LinearPart const& part : linear_) add(sum, part, radius, mu);
    return sum;
}

glm::dvec3 OpticalDepth::above_top(double radius, double mu) const {
    glm::dvec3 sum(0);
    double const p_squared = radius * radius * std::max(0.0, 1 - mu * mu);
    double const mu_top = std::sqrt(std::max(0.0, 1 - p_squared / (top_radius_ * top_radius_)));
    for (ExponentialPart const& part : exponential_) {
        if (part.top_density < 1e-14) continue;
        sum += part.extinction * (part.top_density * part.table.path(top_radius_, mu_top));
    }
    return sum;
}

glm::dvec3 OpticalDepth::to_top(double radius, double mu) const {
    if (mu >= 0) return climbing(radius, mu);
    double const closest = std::max(radius_, radius * std::sqrt(std::max(0.0, 1 - mu * mu)));
    return 2.0 * climbing(closest, 0) - climbing(radius, -mu);
}

DepthAlong::DepthAlong(OpticalDepth const& depth, Ray const& ray) : depth_(&depth), ray_(&ray) {}

glm::dvec3 DepthAlong::at(double distance) const {
    double const radius = ray_->radius_at(distance), mu = (ray_->along + distance) / radius;
    // On the way in, depth still to come to the top behind; on the way out the closest approach is passed as well.
    if (mu < 0) return depth_->rising(radius, -mu);
    if (!inward_) {
        // A ray whose closest approach is inside the planet climbs all the way: any constant serves. One that grazes
        // may seem to be inside by a rounding.
        double const closest = std::sqrt(ray_->closest_squared);
        bool const climbs = closest < depth_->planet_radius() * (1 - 1e-12);
        inward_ = climbs ? glm::dvec3(0) : 2.0 * depth_->rising(closest, 0);
    }
    return *inward_ - depth_->rising(radius, mu);
}

} // namespace alpenglow
