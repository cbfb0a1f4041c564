#pragma once

#include "scene/air.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>

namespace alpenglow {

enum class GroundLook { uniform, procedural };

struct Planet {
    std::string name{};
    double radius = 6'360'000; ///< [m] reference radius, "sea level"
    bool has_air = true;
    Air air{};
    GroundLook look = GroundLook::procedural;
    /// Mean albedo for light in the air; where the look is uniform, of a matte (Lambert) ground all round.
    glm::dvec3 ground_albedo{0.2};
    glm::dvec3 solar_irradiance{1.0}; ///< relative, above the air
    double sun_angular_radius = 0.004675; ///< [rad]
};

/// Earth from sources in docs/atmosphere.md; what a view without a planet gets.
Planet make_earth();

/// A planet file (JSON, assets/planet.schema.json), or the name of one in assets/planets. Throws Error(bad_input).
Planet load_planet(std::filesystem::path const& file_or_name);

} // namespace alpenglow
