// What the air is made of at one altitude.
#ifndef ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#define ALPENGLOW_ATMOSPHERE_DENSITY_GLSL
#include "atmosphere/math.glsl"
#include "interop/atmosphere.h"

// The air's components. GLSL passes structs by value; with these among them drivers take seconds to compile a pass.
#ifdef __cplusplus
#define AIR_CONTENT(atmosphere) (atmosphere).content
#else
#include "interop/frame_block.glsl"
#define AIR_CONTENT(atmosphere) frame.air_content
layout(constant_id = AIR_COMPOSITION_LOW_ID) const int AIR_COMPOSITION_LOW = 0;
layout(constant_id = AIR_COMPOSITION_HIGH_ID) const int AIR_COMPOSITION_HIGH = 0;
#endif

SHADER_NAMESPACE_BEGIN

// What there is at a point, with one entry for each component of the air.
struct Medium {
    vec3 scattering[AIR_COMPONENTS]; // [1/m]
    vec3 extinction;                 // [1/m] scattering and absorption of all together
};

INLINE int component_code(IN(Atmosphere) atmosphere, int i) {
#ifdef __cplusplus
    ivec2 composition = atmosphere.content.composition;
#else
    ivec2 composition = ivec2(AIR_COMPOSITION_LOW, AIR_COMPOSITION_HIGH);
#endif
    return ((i < 4 ? composition.x : composition.y) >> (8 * (i & 3))) & 255;
}

INLINE bool component_scatters(IN(Atmosphere) atmosphere, int i) { return component_code(atmosphere, i) > 127; }

// The share of a ramp's rise at altitude h [m]. `ramp` as in AirContent.
INLINE float ramp_share(vec3 ramp, float h) { return clamp((h - ramp.x) * ramp.y, 0.0f, 1.0f); }

// Relative to where the component's coefficients hold. `next_ramp`: its first ramp; then the next component's.
INLINE float component_density(IN(Atmosphere) atmosphere, int i, INOUT(int) next_ramp, float h) {
    int ramps = (component_code(atmosphere, i) & 127) - 1;
    if (ramps == 0) return exp(h * AIR_CONTENT(atmosphere).components[i].falloff);
    float density = 0.0f;
    for (int j = 0; j < ramps; ++j) {
        vec3 ramp = AIR_CONTENT(atmosphere).ramps[next_ramp + j];
        density += ramp.z * ramp_share(ramp, h);
    }
    next_ramp += ramps;
    return density;
}

INLINE void add_component(INOUT(Medium) medium, IN(Atmosphere) atmosphere, int i, INOUT(int) next_ramp, float h) {
    int code = component_code(atmosphere, i);
    medium.scattering[i] = vec3(0.0f);
    if (code == 0) return;
    float density = component_density(atmosphere, i, next_ramp, h);
    medium.extinction += AIR_CONTENT(atmosphere).components[i].extinction * density;
    if (component_scatters(atmosphere, i))
        medium.scattering[i] = AIR_CONTENT(atmosphere).components[i].scattering * density;
}

// One after the other, not in a loop: with known numbers compilers drop what is not there.
INLINE Medium medium_at(IN(Atmosphere) atmosphere, float h) {
    Medium medium;
    medium.extinction = vec3(0.0f);
    int ramp = 0;
    add_component(medium, atmosphere, 0, ramp, h);
    add_component(medium, atmosphere, 1, ramp, h);
    add_component(medium, atmosphere, 2, ramp, h);
    add_component(medium, atmosphere, 3, ramp, h);
    add_component(medium, atmosphere, 4, ramp, h);
    add_component(medium, atmosphere, 5, ramp, h);
    add_component(medium, atmosphere, 6, ramp, h);
    add_component(medium, atmosphere, 7, ramp, h);
    return medium;
}

// Of all components together [1/m].
INLINE vec3 total_scattering(IN(Medium) medium) {
    vec3 sum = medium.scattering[0];
    for (int i = 1; i < AIR_COMPONENTS; ++i) sum += medium.scattering[i];
    return sum;
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
INLINE CellMedium cell_medium(IN(Medium) begin, IN(Medium) middle, IN(Medium) end) {
    Medium mean;
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        mean.scattering[i] = (begin.scattering[i] + 4.0f * middle.scattering[i] + end.scattering[i]) * (1.0f / 6.0f);
    mean.extinction = (begin.extinction + 4.0f * middle.extinction + end.extinction) * (1.0f / 6.0f);
    float more = total_scattering(end).y - total_scattering(begin).y;
    return CellMedium(mean, LIGHT_TOWARDS_MASS * more / max(12.0f * total_scattering(mean).y, TINY));
}

SHADER_NAMESPACE_END
#endif
