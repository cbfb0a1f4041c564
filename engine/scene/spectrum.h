#pragma once

#include <glm/glm.hpp>

namespace alpenglow {

/// The wavelengths of red, green and blue [m] that the canonical coefficients belong to.
inline glm::dvec3 const CANONICAL_WAVELENGTHS{680e-9, 550e-9, 440e-9};

/// [1/m] of Earth's air at sea level: 1.24062e-6 / lambda^4, lambda in micrometres, as in Bruneton's code of 2017. It
/// follows the inverse fourth power (Rayleigh 1871) alone, without the refractive index' own dispersion.
glm::dvec3 rayleigh_scattering(glm::dvec3 const& wavelengths);

/// Absorption cross section of an ozone molecule [m^2] at a wavelength [m] in OZONE_WAVELENGTHS, linear between means
/// over 10 nm.
double ozone_cross_section(double wavelength);

/// The range of the table of cross sections [m].
constexpr double SHORTEST_WAVELENGTH = 360e-9, LONGEST_WAVELENGTH = 830e-9;

constexpr double DOBSON_UNIT = 2.687e20; ///< [molecules/m^2]

/// Absorption [1/m] of ozone where the density is 1, for a column [Dobson units] spread over a profile whose own column
/// is `profile_column` [m] > 0.
glm::dvec3 ozone_absorption(double dobson_units, double profile_column, glm::dvec3 const& wavelengths);

} // namespace alpenglow
