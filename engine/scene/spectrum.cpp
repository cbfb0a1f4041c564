#include "scene/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alpenglow {

namespace {

/// [m^2] at 233 K from 360 nm on, each the mean over the 10 nm that follow. Measured by the University of Bremen
/// (Gorshelev et al. and Serdyuchenko et al. 2014, www.iup.uni-bremen.de, o3spectra2011), binned as in Bruneton's code
/// of 2017.
constexpr std::array OZONE{1.18e-27,  2.182e-28, 2.818e-28, 6.636e-28, 1.527e-27, 2.763e-27, 5.52e-27,  8.451e-27,
                           1.582e-26, 2.316e-26, 3.669e-26, 4.924e-26, 7.752e-26, 9.016e-26, 1.48e-25,  1.602e-25,
                           2.139e-25, 2.755e-25, 3.091e-25, 3.5e-25,   4.266e-25, 4.672e-25, 4.398e-25, 4.701e-25,
                           5.019e-25, 4.305e-25, 3.74e-25,  3.215e-25, 2.662e-25, 2.238e-25, 1.852e-25, 1.473e-25,
                           1.209e-25, 9.423e-26, 7.455e-26, 6.566e-26, 5.105e-26, 4.15e-26,  4.228e-26, 3.237e-26,
                           2.451e-26, 2.801e-26, 2.534e-26, 1.624e-26, 1.465e-26, 2.078e-26, 1.383e-26, 7.105e-27};
constexpr double BIN = 10e-9; // [m]

} // namespace

glm::dvec3 rayleigh_scattering(glm::dvec3 const& wavelengths) {
    glm::dvec3 const micrometres = 1e6 * wavelengths, squared = micrometres * micrometres;
    return 1.24062e-6 / (squared * squared);
}

double ozone_cross_section(double wavelength) {
    double const place = std::clamp((wavelength - SHORTEST_WAVELENGTH) / BIN, 0.0, OZONE.size() - 1.0);
    std::size_t const bin = std::min(static_cast<std::size_t>(place), OZONE.size() - 2);
    return std::lerp(OZONE[bin], OZONE[bin + 1], place - static_cast<double>(bin));
}

glm::dvec3 ozone_absorption(double dobson_units, double profile_column, glm::dvec3 const& wavelengths) {
    double const number_density = dobson_units * DOBSON_UNIT / profile_column; // [1/m^3] where the density is 1
    return number_density * glm::dvec3(ozone_cross_section(wavelengths.x), ozone_cross_section(wavelengths.y),
                                       ozone_cross_section(wavelengths.z));
}

} // namespace alpenglow
