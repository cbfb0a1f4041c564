// The medium, as shaders and their C++ compile see it. Scalar layout. SI units.
#ifndef ALPENGLOW_INTEROP_ATMOSPHERE_H
#define ALPENGLOW_INTEROP_ATMOSPHERE_H
#include "interop/language.h"

// What there is room for.
#define AIR_COMPONENTS 8
#define AIR_RAMPS 24

#define PHASE_DEGREES 5

// Specialization constants of every compute shader: AirContent.composition. With it known when a pipeline is made,
// what the air does not have costs nothing. Constant 0 is the pass's own.
#define AIR_COMPOSITION_LOW_ID 1
#define AIR_COMPOSITION_HIGH_ID 2

SHADER_NAMESPACE_BEGIN

// A phase's Legendre coefficients a_0 to a_4 less the share f of its light that is taken as if it went straight on:
// a_0 = 1 - f.
struct PhaseMoments {
    float degree[PHASE_DEGREES];
};

// One constituent of the air. Coefficients where its density is 1.
struct AirComponent {
    vec3 scattering;    // [1/m]
    vec3 extinction;    // [1/m] scattering and absorption
    float falloff;      // [1/m] density exp(falloff h), for a component without ramps
    vec2 first_lobe;    // of the phase: g and alpha after Draine, as in engine/scene/phase.h
    vec2 second_lobe;
    float second_share; // 0 to 1
    PhaseMoments moments;
};
CHECK_SIZE(AirComponent, 68);

// What the air is made of.
struct AirContent {
    ivec2 composition; // a byte for each component, from the lowest on: air_component_code
    AirComponent components[AIR_COMPONENTS];
    // Pieces of densities that are linear in altitude, component after component: z times a ramp from 0 at altitude
    // x [m] to 1 at x + 1 / y; y [1/m] > 0.
    vec3 ramps[AIR_RAMPS];
};
CHECK_SIZE(AirContent, 840);

struct Atmosphere {
    float ground_radius;      // [m] reference radius, "sea level"
    float top_altitude;       // [m] above it; no air beyond
    vec3 ground_albedo;       // mean, for light that the ground gives back to the air
    vec3 solar_irradiance;    // relative, above the air
    float sun_angular_radius; // [rad]
#ifdef __cplusplus
    AirContent content;       // for GLSL it stands behind, in FrameConstants: atmosphere/density.glsl
#endif
};
CHECK_SIZE(Atmosphere, 876);

// 0 where there is no component.
INLINE int air_component_code(int ramps, bool scatters) { return 1 + ramps + (scatters ? 128 : 0); }

SHADER_NAMESPACE_END

// Shapes of the tables, in texels.
#define TRANSMITTANCE_WIDTH 512  // cosine of the zenith angle, dense at the horizon
#define TRANSMITTANCE_HEIGHT 128 // altitude
#define MULTIPLE_SCATTERING_WIDTH 48  // sun zenith
#define MULTIPLE_SCATTERING_HEIGHT 24 // altitude; of each tile
#define LIGHT_PARTS 4                  // atmosphere/light_moments.glsl
#define LIGHT_TILES (3 * LIGHT_PARTS)

#endif
