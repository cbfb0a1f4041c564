// The axes of the tables by altitude and sun: x the sun's zenith, dense where it sets; y the altitude, dense at the
// ground.
#ifndef ALPENGLOW_ATMOSPHERE_SUN_MAPPING_GLSL
#define ALPENGLOW_ATMOSPHERE_SUN_MAPPING_GLSL
#include "atmosphere/math.glsl"
#include "interop/atmosphere.h"
SHADER_NAMESPACE_BEGIN

// mu_s = X (B + (1 - B) |X|) with -1 <= X <= 1: a step at the terminator is B of an even one. A linear cosine is 40 to 70 % off
// at -6 degrees.
CONSTANT float SUN_AXIS_SLOPE = 0.1f; // B

// Altitude [m] is clamped to the air.
INLINE vec2 sun_table_uv(IN(Atmosphere) atmosphere, float h, float mu_s, int width, int height) {
    float x = (sqrt(SUN_AXIS_SLOPE * SUN_AXIS_SLOPE + 4.0f * (1.0f - SUN_AXIS_SLOPE) * abs(mu_s)) - SUN_AXIS_SLOPE) /
              (2.0f * (1.0f - SUN_AXIS_SLOPE));
    float y = sqrt(clamp(h / atmosphere.top_altitude, 0.0f, 1.0f));
    return vec2(uv_from_unit(clamp(0.5f + 0.5f * (mu_s < 0.0f ? -x : x), 0.0f, 1.0f), width), uv_from_unit(y, height));
}

// x = altitude [m], y = mu_s.
INLINE vec2 altitude_sun_from_uv(IN(Atmosphere) atmosphere, vec2 uv, int width, int height) {
    float x = 2.0f * clamp(unit_from_uv(uv.x, width), 0.0f, 1.0f) - 1.0f;
    float y = clamp(unit_from_uv(uv.y, height), 0.0f, 1.0f);
    return vec2(atmosphere.top_altitude * y * y, x * (SUN_AXIS_SLOPE + (1.0f - SUN_AXIS_SLOPE) * abs(x)));
}

SHADER_NAMESPACE_END
#endif
