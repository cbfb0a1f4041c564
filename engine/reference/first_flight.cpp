#include "reference/first_flight.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

constexpr int LEG_CELLS = 20;          ///< on the way down to the closest approach, and on the way up
constexpr double CELL_HEIGHT = 20'000; ///< [m] scale height of their spacing; tuned for low noise

double mean(glm::dvec3 const& color) { return (color.x + color.y + color.z) / 3; }

/// In place: to the sum 1. False where there is nothing.
bool normalize_sum(std::vector<double>& weights) {
    double sum = 0;
    for (double const w : weights) sum += w;
    if (!(sum > 0)) return false;
    for (double& w : weights) w /= sum;
    return true;
}

} // namespace

FirstFlight::FirstFlight(Medium const& medium, OpticalDepth const& depth, Sunlight const& sun,
                         LightGuide const& guide, Ray const& ray, double from, double to)
    : ray_(ray), depth_(depth, ray), start_(depth_.at(from)) {
    double const closest = std::clamp(-ray.along, from, to);
    add_cells(closest, from, medium.radius);
    std::ranges::reverse(edges_);
    if (!edges_.empty()) edges_.pop_back();
    add_cells(closest, to, medium.radius);
    // Near the camera cells shrink with the distance.
    double const first = edges_[1] - edges_[0];
    for (double const share : {0.5, 0.25, 0.1, 0.03}) edges_.insert(edges_.begin() + 1, from + share * first);

    std::vector<double> const weights = cell_light(medium, sun, guide);
    cumulative_.push_back(0);
    for (double const w : weights) cumulative_.push_back(cumulative_.back() + w);
    cumulative_.back() = 1;
}

/// Edges from the lower end of a stretch to its upper end, at altitude quantiles that are dense at the lower one.
void FirstFlight::add_cells(double from, double to, double radius) {
    if (from == to) return;
    double const lowest = ray_.radius_at(from) - radius, highest = ray_.radius_at(to) - radius;
    double const widest = std::sqrt(-std::expm1(-(highest - lowest) / CELL_HEIGHT));
    double const sign = to > from ? 1 : -1;
    edges_.push_back(from);
    for (int i = 1; i < LEG_CELLS; ++i) {
        double const x = widest * i / LEG_CELLS;
        double const r = radius + lowest - CELL_HEIGHT * std::log1p(-x * x);
        edges_.push_back(-ray_.along + sign * std::sqrt(std::max(0.0, r * r - ray_.closest_squared)));
    }
    edges_.push_back(to);
}

/// Shares of the choices for each cell, from its middle.
std::vector<double> FirstFlight::cell_light(Medium const& medium, Sunlight const& sun,
                                            LightGuide const& guide) const {
    double const cosine = dot(ray_.direction, sun.source().to_sun);
    std::vector<double> once, bright, plain;
    for (std::size_t i = 1; i < edges_.size(); ++i) {
        double const middle = 0.5 * (edges_[i - 1] + edges_[i]), width = std::max(0.0, edges_[i] - edges_[i - 1]);
        double const altitude = ray_.radius_at(middle) - medium.radius;
        glm::dvec3 towards_camera(0), scattering(0);
        for (Component const& component : medium.components) {
            glm::dvec3 const here = component.scattering * density(component.profile, altitude);
            scattering += here;
            towards_camera += here * phase_value(component.phase, cosine);
        }
        glm::dvec3 const seen = exp(start_ - depth_.at(middle)) * width;
        once.push_back(mean(seen * towards_camera * sun.unshadowed(ray_.at(middle))));
        plain.push_back(mean(seen * scattering) + 1e-300 * width);
        bright.push_back(plain.back() * guide.brightness(ray_.at(middle)));
    }
    normalize_sum(plain);
    normalize_sum(bright);
    double const once_share = normalize_sum(once) ? 0.4 : 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        plain[i] = 0.1 * plain[i] + (0.9 - once_share) * bright[i] + once_share * once[i];
    }
    return plain;
}

FirstFlight::Choice FirstFlight::choose(double u) const {
    auto const above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
    auto const i = static_cast<std::size_t>(above - cumulative_.begin());
    double const share = cumulative_[i] - cumulative_[i - 1], width = edges_[i] - edges_[i - 1];
    double const distance = edges_[i - 1] + std::min((u - cumulative_[i - 1]) / share, 1.0) * width;
    return {distance, exp(start_ - depth_.at(distance)) * (width / share)};
}

glm::dvec3 FirstFlight::transmittance() const { return exp(start_ - depth_.at(edges_.back())); }

} // namespace alpenglow
