// The medium, as shaders and their C++ compile see it. Scalar layout. SI units.
#ifndef ALPENGLOW_INTEROP_ATMOSPHERE_H
#define ALPENGLOW_INTEROP_ATMOSPHERE_H
#include "interop/language.h"

#define PHASE_DEGREES 5
#define RAYLEIGH_MOMENTS 0
#define AEROSOL_MOMENTS 1

SHADER_NAMESPACE_BEGIN

// A phase's Legendre coefficients a_0 to a_4 less the share f of its light that is taken as if it went straight on:
// a_0 = 1 - f.
struct PhaseMoments {
    float degree[PHASE_DEGREES];
};

struct Atmosphere {
    float ground_radius;         // [m] reference radius, "sea level"
    float top_altitude;          // [m] above it; no air beyond
    vec3 rayleigh_scattering;    // [1/m] at sea level; Rayleigh absorbs nothing
    float rayleigh_scale_height; // [m]
    vec3 aerosol_scattering;     // [1/m] at sea level
    float aerosol_scale_height;  // [m]
    vec3 aerosol_extinction;     // [1/m] at sea level
    float aerosol_g;             // asymmetry of the Cornette-Shanks phase
    vec3 ozone_absorption;       // [1/m] at the tent's peak
    float ozone_centre;          // [m] altitude of the peak
    float ozone_half_width;      // [m]
    vec3 ground_albedo;          // mean, for light that the ground gives back to the air
    vec3 solar_irradiance;       // relative, above the air
    float sun_angular_radius;    // [rad]
    PhaseMoments phase_moments[2]; // RAYLEIGH_MOMENTS, AEROSOL_MOMENTS
};
CHECK_SIZE(Atmosphere, 144);

SHADER_NAMESPACE_END

// Shapes of the tables, in texels.
#define TRANSMITTANCE_WIDTH 512  // cosine of the zenith angle, dense at the horizon
#define TRANSMITTANCE_HEIGHT 128 // altitude
#define MULTIPLE_SCATTERING_WIDTH 48  // sun zenith
#define MULTIPLE_SCATTERING_HEIGHT 24 // altitude; of each tile
#define LIGHT_TILES 6                 // atmosphere/light_moments.glsl

#endif
