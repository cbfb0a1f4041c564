// Phase functions [1/sr], normalised to 1 over the sphere. nu is the cosine between the view direction (camera to
// sample) and the direction from the sample to the sun: a forward peak lies at nu = 1, around the sun's disc.
#ifndef ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#define ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#include "atmosphere/math.glsl"
#include "interop/atmosphere.h"
SHADER_NAMESPACE_BEGIN

CONSTANT float ISOTROPIC_PHASE = 1.0f / (4.0f * PI);

// (1 - g²) / (4 pi (1 + g² - 2 g nu)^(3/2)): Henyey and Greenstein 1941. -1 < g < 1.
INLINE float henyey_greenstein_phase(float nu, float g) {
    float base = (1.0f - g) * (1.0f - g) + 2.0f * g * (1.0f - nu);
    return (1.0f - g * g) / (4.0f * PI * base * sqrt(base));
}

// The same times (1 + alpha nu²) / (1 + alpha (1 + 2 g²) / 3): Draine 2003. alpha = 1 is Cornette's and Shanks' (1992;
// as in Dereyne's Eq. 6 but for his factor 4 pi), with g = 0 Rayleigh's, 3 / (16 pi) (1 + nu²).
INLINE float draine_phase(float nu, float g, float alpha) {
    return (1.0f + alpha * nu * nu) / (1.0f + alpha * (1.0f + 2.0f * g * g) / 3.0f) * henyey_greenstein_phase(nu, g);
}

INLINE float component_phase(AirComponent component, float nu) {
    return mix(draine_phase(nu, component.first_lobe.x, component.first_lobe.y),
               draine_phase(nu, component.second_lobe.x, component.second_lobe.y), component.second_share);
}

SHADER_NAMESPACE_END
#endif
