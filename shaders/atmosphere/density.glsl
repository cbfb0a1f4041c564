// What the air is made of at one altitude. Needs positive scale heights and a positive width of the ozone's tent.
#ifndef ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#define ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#include "interop/atmosphere.h"
SHADER_NAMESPACE_BEGIN

struct Medium {
    vec3 rayleigh_scattering; // [1/m]
    vec3 aerosol_scattering;  // [1/m]
    vec3 extinction;          // [1/m] scattering and absorption of all that is there
};

// Density relative to sea level.
INLINE float exponential_density(float h, float scale_height) { return exp(-h / scale_height); }

// Density relative to the peak. The ozone profile of Bruneton's and Hillaire's code; 300 Dobson units on Earth.
INLINE float ozone_density(Atmosphere atmosphere, float h) {
    return max(0.0f, 1.0f - abs(h - atmosphere.ozone_centre) / atmosphere.ozone_half_width);
}

INLINE Medium medium_at(Atmosphere atmosphere, float h) {
    float rayleigh = exponential_density(h, atmosphere.rayleigh_scale_height);
    float aerosol = exponential_density(h, atmosphere.aerosol_scale_height);
    vec3 scattered = atmosphere.rayleigh_scattering * rayleigh;
    vec3 extinction = scattered + atmosphere.aerosol_extinction * aerosol +
                      atmosphere.ozone_absorption * ozone_density(atmosphere, h);
    return Medium(scattered, atmosphere.aerosol_scattering * aerosol, extinction);
}

SHADER_NAMESPACE_END
#endif
