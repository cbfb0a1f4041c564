#pragma once

#include "scene/planet.h"

#include <glm/glm.hpp>

#include <vector>

namespace alpenglow {

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

/// The planet's air, but for what is switched off. No components where it has none.
Medium make_medium(Planet const& planet);

} // namespace alpenglow
