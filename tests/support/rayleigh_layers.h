#pragma once

#include <array>

namespace alpenglow::test {

/// Radiance in the sun's plane that leaves a plane-parallel layer of scalar Rayleigh scattering (no polarization, no
/// ground). A beam of irradiance pi on a plane across it comes in at the cosine SWEIGART_MU0.
///
/// Numbers: the "correct answers" of test problem 2 in cdisort's disotest.c (Dowling 2011, after the DISORT of Stamnes,
/// Tsay, Wiscombe and Jayaweera 1988), five to six digits. That file gives as their origin Sweigart, Radiative transfer
/// in atmospheres scattering according to the Rayleigh phase function with absorption, Astrophysical Journal Supplement
/// 22, 1970, table 1; the paper itself was not at hand.
struct RayleighLayer {
    double depth;               ///< optical thickness
    double albedo;              ///< of single scattering
    double flux_up, flux_down;  ///< diffuse, through the top and through the bottom
    std::array<double, 3> up;   ///< radiance at the top towards the cosines SWEIGART_MU
    std::array<double, 3> down; ///< the same at the bottom, downwards
};

/// Light that goes these ways has its azimuth from the beam's own way, 0: it moves on as the beam does.
inline constexpr std::array<double, 3> SWEIGART_MU = {0.018014, 0.538263, 0.981986};
inline constexpr double SWEIGART_MU0 = 0.080442;

inline constexpr std::array<RayleighLayer, 4> SWEIGART_LAYERS = {{
    {0.2, 0.5, 5.35063e-2, 4.41791e-2, {1.61796e-1, 2.11501e-2, 7.86713e-3}, {2.57685e-2, 2.00778e-2, 7.71897e-3}},
    {0.2, 1.0, 1.25561e-1, 1.06123e-1, {3.47678e-1, 4.87120e-2, 1.89387e-2}, {6.77603e-2, 4.64061e-2, 1.86027e-2}},
    {5.0, 0.5, 6.24730e-2, 2.51683e-4, {1.62566e-1, 2.45786e-2, 1.01498e-2}, {1.32472e-5, 3.97168e-5, 1.70004e-4}},
    {5.0, 1.0, 2.25915e-1, 2.68008e-2, {3.64010e-1, 8.26993e-2, 4.92370e-2}, {3.79276e-3, 7.69337e-3, 1.05950e-2}},
}};

} // namespace alpenglow::test
