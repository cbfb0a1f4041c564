#include "render/atmosphere_constants.h"

#include "render/phase_moments.h"

#include <cassert>

namespace alpenglow {

namespace {

static_assert(MOST_AIR_COMPONENTS == AIR_COMPONENTS && MOST_PROFILE_PIECES == AIR_RAMPS);

constexpr double STEP = 1; // [m] over which a step of a profile rises

/// Half below and half above, but whole at the ground.
glm::vec3 step_at(double altitude, double rise) {
    double const bottom = altitude < STEP / 2 ? altitude - STEP : altitude - STEP / 2;
    return glm::vec3(bottom, 1 / STEP, rise);
}

/// The ramps whose sum is the profile, as in AirContent.
std::vector<glm::vec3> ramps_of(LinearProfile const& profile) {
    using Node = LinearProfile::Node;
    std::vector<glm::vec3> ramps;
    auto const add = [&](Node const& a, Node const& b) {
        double const rise = b.density - a.density, height = b.altitude - a.altitude;
        if (rise == 0) return;
        if (height < STEP) return ramps.push_back(step_at(a.altitude, rise));
        ramps.emplace_back(a.altitude, 1 / height, rise);
    };
    if (profile.nodes.empty()) return ramps;
    add({profile.nodes.front().altitude, 0}, profile.nodes.front());
    for (std::size_t i = 1; i < profile.nodes.size(); ++i) add(profile.nodes[i - 1], profile.nodes[i]);
    add(profile.nodes.back(), {profile.nodes.back().altitude, 0});
    return ramps;
}

void set_phase(shader::AirComponent& component, PhaseLobes const& lobes) {
    component.first_lobe = glm::vec2(lobes.first.g, lobes.first.alpha);
    component.second_lobe = glm::vec2(lobes.second.g, lobes.second.alpha);
    component.second_share = static_cast<float>(lobes.second_share);
    component.moments = phase_moments(lobes);
}

} // namespace

shader::Atmosphere atmosphere_of(Planet const& planet) {
    Air const& air = planet.air;
    assert(air.components.size() <= MOST_AIR_COMPONENTS);
    shader::Atmosphere a{};
    a.ground_radius = static_cast<float>(planet.radius);
    a.top_altitude = static_cast<float>(air.top_altitude);
    int next_ramp = 0;
    for (std::size_t i = 0; i < air.components.size(); ++i) {
        AirComponent const& from = air.components[i];
        shader::AirComponent& to = a.content.components[i];
        if (from.on) to.scattering = glm::vec3(from.scattering), to.extinction = glm::vec3(from.extinction());
        set_phase(to, lobes_of(from.phase));
        int ramps = 0;
        if (auto const* const exponential = std::get_if<ExponentialProfile>(&from.profile)) {
            to.falloff = static_cast<float>(-1 / exponential->scale_height);
        } else {
            for (glm::vec3 const& ramp : ramps_of(std::get<LinearProfile>(from.profile)))
                a.content.ramps[next_ramp + ramps++] = ramp;
        }
        next_ramp += ramps;
        bool const scatters = from.scattering != glm::dvec3(0);
        a.content.composition[static_cast<int>(i / 4)] |= shader::air_component_code(ramps, scatters) << (8 * (i % 4));
    }
    a.ground_albedo = glm::vec3(planet.ground_albedo);
    a.solar_irradiance = glm::vec3(planet.solar_irradiance);
    a.sun_angular_radius = static_cast<float>(planet.sun_angular_radius);
    return a;
}

} // namespace alpenglow
