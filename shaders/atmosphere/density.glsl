// What the air is made of at one altitude. Needs positive scale heights and a positive width of the ozone's tent.
#ifndef ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#define ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#include "atmosphere/math.glsl"
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

// The air of a cell of a march.
struct CellMedium {
    Medium mean;
    float centre; // where to look at the light: from the middle on, in lengths of the cell, -1/2 to 1/2
};

// Light grows exponentially out of the planet's shadow, so that its mean lies between that at the middle and that at
// the centre of mass. Tuned against fine marches with the sun at 60 to -6 degrees: mean light of the first order in 32
// cells is 0.1 % off, where the middle gives up to 1.3 % and the centre of mass 0.6 %.
CONSTANT float LIGHT_TOWARDS_MASS = 0.7f;

// From both ends and the middle by Simpson's rule: cells may be as long as two scale heights.
INLINE CellMedium cell_medium(Medium begin, Medium middle, Medium end) {
    Medium mean =
        Medium((begin.rayleigh_scattering + 4.0f * middle.rayleigh_scattering + end.rayleigh_scattering) * (1.0f / 6.0f),
               (begin.aerosol_scattering + 4.0f * middle.aerosol_scattering + end.aerosol_scattering) * (1.0f / 6.0f),
               (begin.extinction + 4.0f * middle.extinction + end.extinction) * (1.0f / 6.0f));
    float more = end.rayleigh_scattering.y + end.aerosol_scattering.y - begin.rayleigh_scattering.y -
                 begin.aerosol_scattering.y;
    float all = mean.rayleigh_scattering.y + mean.aerosol_scattering.y;
    return CellMedium(mean, LIGHT_TOWARDS_MASS * more / max(12.0f * all, TINY));
}

SHADER_NAMESPACE_END
#endif
