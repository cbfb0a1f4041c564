#include "scene/air.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace alpenglow {

namespace {

double linear_column(LinearProfile const& profile, double top) {
    double sum = 0;
    for (std::size_t i = 1; i < profile.nodes.size(); ++i) {
        LinearProfile::Node const &a = profile.nodes[i - 1], &b = profile.nodes[i];
        double const low = std::clamp(a.altitude, 0.0, top), high = std::clamp(b.altitude, 0.0, top);
        if (high <= low) continue;
        double const slope = (b.density - a.density) / (b.altitude - a.altitude);
        sum += (high - low) * (a.density + slope * (0.5 * (low + high) - a.altitude));
    }
    return sum;
}

} // namespace

LinearProfile tent_profile(double centre, double half_width) {
    return {{{centre - half_width, 0}, {centre, 1}, {centre + half_width, 0}}};
}

LinearProfile shell_profile(double bottom, double top) { return {{{bottom, 1}, {top, 1}}}; }

double profile_column(Profile const& profile, double top) {
    if (auto const* const exponential = std::get_if<ExponentialProfile>(&profile))
        return exponential->scale_height * -std::expm1(-top / exponential->scale_height);
    return linear_column(std::get<LinearProfile>(profile), top);
}

std::size_t piece_count(Profile const& profile) {
    auto const* const linear = std::get_if<LinearProfile>(&profile);
    if (!linear || linear->nodes.empty()) return 0;
    std::size_t count = (linear->nodes.front().density != 0) + (linear->nodes.back().density != 0);
    for (std::size_t i = 1; i < linear->nodes.size(); ++i)
        count += linear->nodes[i].density != linear->nodes[i - 1].density;
    return count;
}

AirComponent* Air::find(std::string_view name) {
    auto const found = std::ranges::find(components, name, &AirComponent::name);
    return found == components.end() ? nullptr : &*found;
}

AirComponent& Air::at(std::string_view name) {
    AirComponent* const found = find(name);
    assert(found);
    return *found;
}

AirComponent const& Air::at(std::string_view name) const { return const_cast<Air&>(*this).at(name); }

} // namespace alpenglow
