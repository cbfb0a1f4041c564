#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace alpenglow {

/// What decides how a piece of ground looks.
struct GroundPlace {
    double east = 0, north = 0; ///< [m]
    double altitude = 0;        ///< [m]
    double slope = 0;           ///< tangent of the steepness
    double northward = 0;       ///< -1 faces south, 1 faces north; 0 where level
    double gully = 0;           ///< -1 in a gully, 1 on a rib
};

/// Linear Rec.709 albedo: sand, forest, meadow, scree, rock and snow by altitude, slope and aspect.
glm::dvec3 ground_albedo(std::uint32_t seed, GroundPlace const& place);

} // namespace alpenglow
