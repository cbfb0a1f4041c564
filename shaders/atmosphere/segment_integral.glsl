// Light gathered along a ray, cell by cell from the camera on, each cell homogeneous and integrated exactly.
#ifndef ALPENGLOW_ATMOSPHERE_SEGMENT_INTEGRAL_GLSL
#define ALPENGLOW_ATMOSPHERE_SEGMENT_INTEGRAL_GLSL
#include "atmosphere/math.glsl"
SHADER_NAMESPACE_BEGIN

struct AirLight {
    vec3 inscattered;   // radiance, in the unit of the sources times a metre
    vec3 transmittance; // from the camera to the end of the last cell
};

INLINE AirLight no_air_light() { return AirLight(vec3(0.0f), vec3(1.0f)); }

// The integral of source · exp(-extinction s) over 0 <= s <= length [m]: source (1 - exp(-extinction length)) /
// extinction.
INLINE vec3 integrate_segment(vec3 source, vec3 extinction, float segment_length) {
    return source * mean_transmittance3(extinction * segment_length) * segment_length;
}

// Adds the next cell: its source [radiance/m] and extinction [1/m] as in its middle, its length [m]. One exponential for
// what the cell lets through and what it adds.
INLINE void add_cell(INOUT(AirLight) light, vec3 source, vec3 extinction, float segment_length) {
    vec3 depth = extinction * segment_length;
    vec3 through = exp(-depth);
    vec3 mean = vec3(mean_transmittance_of(depth.x, through.x), mean_transmittance_of(depth.y, through.y),
                     mean_transmittance_of(depth.z, through.z));
    light.inscattered += light.transmittance * source * mean * segment_length;
    light.transmittance *= through;
}

// What the camera sees of a surface behind the air.
INLINE vec3 behind_air(AirLight light, vec3 surface_radiance) {
    return surface_radiance * light.transmittance + light.inscattered;
}

SHADER_NAMESPACE_END
#endif
