#pragma once

#include <glm/glm.hpp>

#include <filesystem>
#include <string>

namespace alpenglow {

/// A medium whose density falls off as exp(-h / scale_height). Coefficients at sea level.
struct ExponentialMedium {
    glm::dvec3 scattering{0};   ///< [1/m]
    glm::dvec3 extinction{0};   ///< [1/m], scattering + absorption
    double scale_height = 8000; ///< [m]
};

/// The air of a planet. Coefficients belong to the wavelengths 680, 550, 440 nm unless the planet file says otherwise.
struct Air {
    double top_altitude = 1e5;       ///< [m] above the reference radius; nothing beyond
    ExponentialMedium rayleigh;      ///< phase: Rayleigh
    ExponentialMedium aerosol;       ///< phase: Cornette-Shanks
    double aerosol_g = 0.8;          ///< asymmetry, -1 < g < 1
    glm::dvec3 ozone_absorption{0};  ///< [1/m] at the tent's peak
    double ozone_centre = 25000;     ///< [m] altitude of the peak
    double ozone_half_width = 15000; ///< [m] the tent reaches 0 this far from its centre
};

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
