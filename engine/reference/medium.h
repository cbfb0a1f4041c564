#pragma once

#include "reference/phase.h"
#include "scene/planet.h"

#include <glm/glm.hpp>

#include <variant>
#include <vector>

namespace alpenglow {

/// exp(-altitude / scale_height), up to the medium's top.
struct ExponentialProfile {
    double scale_height = 8000; ///< [m]
};

/// Linear between the nodes, 0 outside: a tent, a shell of constant density, a table. Altitudes increase; two nodes at
/// one altitude make a step.
struct LinearProfile {
    struct Node {
        double altitude = 0; ///< [m]
        double density = 0;
    };
    std::vector<Node> nodes;
};

using Profile = std::variant<ExponentialProfile, LinearProfile>;

/// Share of the component's coefficients at an altitude [m].
double density(Profile const& profile, double altitude);
/// Largest density between two altitudes [m].
double largest_density(Profile const& profile, double lowest, double highest);

/// One constituent of the air. Coefficients where the density is 1.
struct Component {
    glm::dvec3 scattering{0}; ///< [1/m]
    glm::dvec3 extinction{0}; ///< [1/m], scattering + absorption
    Profile profile;
    PhaseLobes phase;
};

/// Everything that scatters and absorbs around a planet, from its reference radius to the top.
struct Medium {
    double radius = 6'360'000; ///< [m]
    double top = 1e5;          ///< [m] altitude; nothing beyond
    std::vector<Component> components;

    double top_radius() const { return radius + top; }
    glm::dvec3 extinction(double altitude) const; ///< [1/m]
};

/// The planet's air: Rayleigh, the aerosol by Cornette and Shanks, the ozone's tent. No components where it has none.
Medium make_medium(Planet const& planet);

} // namespace alpenglow
