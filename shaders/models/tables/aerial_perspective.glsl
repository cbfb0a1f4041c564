// The air between the camera and what it sees, in slices of a grid on the view's frustum: a slice ends at the squared share
// of the table's reach. Table: AERIAL_SLICES beside each other, each AERIAL_SIZE squared with its outer texels on the
// picture's edges; above rgb = in-scattered radiance per unit of solar irradiance, below the transmittance in colour.
#ifndef ALPENGLOW_MODELS_TABLES_AERIAL_PERSPECTIVE_GLSL
#define ALPENGLOW_MODELS_TABLES_AERIAL_PERSPECTIVE_GLSL
#include "atmosphere/segment_integral.glsl"
#include "interop/models/tables.h"
SHADER_NAMESPACE_BEGIN

CONSTANT float LEAST_AERIAL_REACH = 128e3f; // [m] Hillaire's: 32 slices of 4 km

// How far the table reaches [m] from altitude h [m]: to the horizon and behind it, where peaks stand.
INLINE float aerial_reach(float ground_radius, float h) {
    return LEAST_AERIAL_REACH + sqrt(max(h, 0.0f) * (2.0f * ground_radius + max(h, 0.0f)));
}

// Distance [m] of the end of a slice.
INLINE float aerial_distance(float reach, int slice) {
    float share = float(slice + 1) / float(AERIAL_SLICES);
    return reach * share * share;
}

// `place`: in the picture, 0 to 1 from edge to edge.
INLINE vec2 aerial_uv(vec2 place, int slice, bool transmittance) {
    float x = (float(slice) + uv_from_unit(clamp(place.x, 0.0f, 1.0f), AERIAL_SIZE)) / float(AERIAL_SLICES);
    float y = uv_from_unit(clamp(place.y, 0.0f, 1.0f), AERIAL_SIZE) * 0.5f;
    return vec2(x, transmittance ? y + 0.5f : y);
}

// Between the camera and a distance [m].
INLINE AirLight sample_aerial_perspective(sampler2D table, float reach, vec2 place, float distance) {
    float slice = sqrt(clamp(distance / reach, 0.0f, 1.0f)) * float(AERIAL_SLICES) - 1.0f; // -1: the camera
    int far = clamp(int(ceil(slice)), 0, AERIAL_SLICES - 1);
    int near = max(far - 1, 0);
    float share = clamp(slice - float(far - 1), 0.0f, 1.0f);
    AirLight begin = no_air_light();
    if (far > 0) {
        begin.inscattered = vec3(sample_bilinear(table, aerial_uv(place, near, false)));
        begin.transmittance = vec3(sample_bilinear(table, aerial_uv(place, near, true)));
    }
    vec3 inscattered = vec3(sample_bilinear(table, aerial_uv(place, far, false)));
    vec3 transmittance = vec3(sample_bilinear(table, aerial_uv(place, far, true)));
    return AirLight(mix(begin.inscattered, inscattered, share), mix(begin.transmittance, transmittance, share));
}

SHADER_NAMESPACE_END
#endif
