// Phase functions [1/sr], normalised to 1 over the sphere. nu is the cosine between the view direction (camera to
// sample) and the direction from the sample to the sun: a forward peak lies at nu = 1, around the sun's disc.
#ifndef ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#define ALPENGLOW_ATMOSPHERE_PHASE_GLSL
#include "atmosphere/density.glsl"
#include "atmosphere/light_moments.glsl"
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

// The phases of one ray: constant along it.
struct RayPhases {
    float of_component[AIR_COMPONENTS]; // [1/sr]
    float series[AIR_COMPONENTS];       // the same by its first coefficients; the mean over all directions is that of degree 0
};

INLINE RayPhases phases_of(IN(Atmosphere) atmosphere, float nu) {
    RayPhases phases;
    for (int i = 0; i < AIR_COMPONENTS; ++i) {
        phases.of_component[i] = phases.series[i] = 0.0f;
        if (!component_scatters(atmosphere, i)) continue;
        phases.of_component[i] = component_phase(AIR_CONTENT(atmosphere).components[i], nu);
        phases.series[i] = phase_series(AIR_CONTENT(atmosphere).components[i].moments, nu);
    }
    return phases;
}

// Scattering times phase of all components together [1/(m sr)].
INLINE vec3 directed_scattering(IN(Medium) medium, IN(RayPhases) phases) {
    vec3 sum = medium.scattering[0] * phases.of_component[0];
    for (int i = 1; i < AIR_COMPONENTS; ++i) sum += medium.scattering[i] * phases.of_component[i];
    return sum;
}

SHADER_NAMESPACE_END
#endif
