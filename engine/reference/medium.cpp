#include "reference/medium.h"

#include <algorithm>
#include <cmath>

namespace alpenglow {

namespace {

double linear_density(LinearProfile const& profile, double altitude) {
    auto const& nodes = profile.nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        LinearProfile::Node const &a = nodes[i - 1], &b = nodes[i];
        if (altitude < a.altitude || altitude >= b.altitude) continue;
        return a.density + (b.density - a.density) * (altitude - a.altitude) / (b.altitude - a.altitude);
    }
    return 0;
}

double largest_linear_density(LinearProfile const& profile, double lowest, double highest) {
    double largest = std::max(linear_density(profile, lowest), linear_density(profile, highest));
    for (LinearProfile::Node const& node : profile.nodes) {
        if (node.altitude >= lowest && node.altitude <= highest) largest = std::max(largest, node.density);
    }
    return largest;
}

} // namespace

double density(Profile const& profile, double altitude) {
    if (auto const* const exponential = std::get_if<ExponentialProfile>(&profile)) {
        return std::exp(-altitude / exponential->scale_height);
    }
    return linear_density(std::get<LinearProfile>(profile), altitude);
}

double largest_density(Profile const& profile, double lowest, double highest) {
    if (std::holds_alternative<ExponentialProfile>(profile)) return density(profile, lowest);
    return largest_linear_density(std::get<LinearProfile>(profile), lowest, highest);
}

glm::dvec3 Medium::extinction(double altitude) const {
    glm::dvec3 sum(0);
    for (Component const& component : components) sum += component.extinction * density(component.profile, altitude);
    return sum;
}

Medium make_medium(Planet const& planet) {
    Medium medium{.radius = planet.radius, .top = planet.air.top_altitude, .components = {}};
    if (!planet.has_air) return medium;
    for (AirComponent const& part : planet.air.components) {
        if (!part.on) continue;
        medium.components.push_back({part.scattering, part.extinction(), part.profile, lobes_of(part.phase)});
    }
    return medium;
}

} // namespace alpenglow
