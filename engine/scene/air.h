#pragma once

#include "scene/phase.h"

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace alpenglow {

/// exp(-altitude / scale_height).
struct ExponentialProfile {
    double scale_height = 8000; ///< [m]

    bool operator==(ExponentialProfile const&) const = default;
};

/// Linear between the nodes, 0 outside: a tent, a shell of constant density, a table. Altitudes do not decrease; two
/// nodes at one altitude make a step.
struct LinearProfile {
    struct Node {
        double altitude = 0; ///< [m] above the reference radius
        double density = 0;

        bool operator==(Node const&) const = default;
    };
    std::vector<Node> nodes;

    bool operator==(LinearProfile const&) const = default;
};

/// The share of a component's coefficients by altitude.
using Profile = std::variant<ExponentialProfile, LinearProfile>;

/// 1 at the centre, 0 from half_width on, both in metres.
LinearProfile tent_profile(double centre, double half_width);
/// 1 between two altitudes [m].
LinearProfile shell_profile(double bottom, double top);

/// The integral of the density from the ground to an altitude [m].
double profile_column(Profile const& profile, double top);

/// One constituent of the air. Coefficients where the density is 1.
struct AirComponent {
    std::string name{};
    glm::dvec3 scattering{0}; ///< [1/m]
    glm::dvec3 absorption{0}; ///< [1/m]
    Phase phase{};
    Profile profile{};
    bool on = true; ///< off: as if it were not there

    glm::dvec3 extinction() const { return scattering + absorption; }
};

/// What shaders have room for.
constexpr std::size_t MOST_AIR_COMPONENTS = 8;
constexpr std::size_t MOST_PROFILE_PIECES = 24; ///< of all linear profiles together

/// The pieces of which a linear profile is made on the device: slopes, and steps, at the ends too.
std::size_t piece_count(Profile const& profile);

/// The air of a planet. Coefficients belong to the wavelengths 680, 550, 440 nm unless the planet file says otherwise.
struct Air {
    double top_altitude = 1e5; ///< [m] above the reference radius; nothing beyond
    std::vector<AirComponent> components{};

    /// nullptr where there is none of that name.
    AirComponent* find(std::string_view name);
    /// There must be one of that name.
    AirComponent& at(std::string_view name);
    AirComponent const& at(std::string_view name) const;
};

} // namespace alpenglow
