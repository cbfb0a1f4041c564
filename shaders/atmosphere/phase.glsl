// Phase functions [1/sr], normalised to 1 over the sphere. nu is the cosine between the view direction (camera to
// sample) and the direction from the sample to the sun: a forward peak lies at nu = 1, around the sun's disc.
#ifndef ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#define ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#include "atmosphere/math.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT float ISOTROPIC_PHASE = 1.0f / (4.0f * PI);

// 3 / (16 pi) (1 + nu²): Fernández Arenas, section 2.1.
INLINE float rayleigh_phase(float nu) { return 3.0f / (16.0f * PI) * (1.0f + nu * nu); }

// (1 - g²) / (4 pi (1 + g² - 2 g nu)^(3/2)): Henyey and Greenstein 1941. -1 < g < 1.
INLINE float henyey_greenstein_phase(float nu, float g) {
    float base = (1.0f - g) * (1.0f - g) + 2.0f * g * (1.0f - nu);
    return (1.0f - g * g) / (4.0f * PI * base * sqrt(base));
}

// 3 (1 - g²) (1 + nu²) / (8 pi (2 + g²) (1 + g² - 2 g nu)^(3/2)): Cornette and Shanks 1992, as in Dereyne's Eq. 6 but
// for his factor 4 pi. -1 < g < 1; Rayleigh's phase at g = 0.
INLINE float cornette_shanks_phase(float nu, float g) {
    return 1.5f * (1.0f + nu * nu) / (2.0f + g * g) * henyey_greenstein_phase(nu, g);
}

SHADER_NAMESPACE_END
#endif
