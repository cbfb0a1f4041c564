// Transfer functions and tone curves, each with its inverse where it has one.
#ifndef ALPENGLOW_ENCODING_COLOR
#define ALPENGLOW_ENCODING_COLOR
#include "interop/display.h"
SHADER_NAMESPACE_BEGIN

// IEC 61966-2-1. Linear 0 to 1 and back.
INLINE float srgb_from_linear(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f; }
INLINE float linear_from_srgb(float x) { return x <= 0.04045f ? x / 12.92f : pow((x + 0.055f) / 1.055f, 2.4f); }

INLINE vec3 srgb_from_linear3(vec3 c) { return vec3(srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)); }
INLINE vec3 linear_from_srgb3(vec3 c) { return vec3(linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z)); }

// 1 - exp(-x): Fernandez Arenas, figure 13.
INLINE vec3 exponential_curve(vec3 x) { return vec3(1.0f) - exp(-x); }

// A filmic curve with a toe and a shoulder: the rational fit of the ACES reference rendering for Rec.709 displays by
// Narkowicz (2015), with his exposure factor of 0.6. Keeps hue better with a touch of desaturation towards white.
INLINE vec3 filmic_curve(vec3 exposed) {
    vec3 radiance = min(exposed, vec3(1e6f)); // white long before; its square is finite
    float luminance = dot(radiance, vec3(0.2126f, 0.7152f, 0.0722f));
    float bleach = luminance / (luminance + 4.0f); // tuned: the sun's surroundings go white instead of yellow-green
    vec3 x = mix(radiance, vec3(luminance), 0.5f * bleach) * 0.6f;
    return clamp((x * (2.51f * x + vec3(0.03f))) / (x * (2.43f * x + vec3(0.59f)) + vec3(0.14f)), vec3(0.0f), vec3(1.0f));
}

// `curve` of interop/display.h.
INLINE vec3 tone_curve(int curve, vec3 exposed) {
    if (curve == CURVE_NONE) return exposed;
    if (curve == CURVE_LINEAR) return clamp(exposed, vec3(0.0f), vec3(1.0f));
    return curve == CURVE_FILMIC ? filmic_curve(exposed) : exponential_curve(exposed);
}

// Interleaved gradient noise (Jimenez 2014), 0 to 1, by pixel.
INLINE float gradient_noise(vec2 pixel) { return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f)))); }

SHADER_NAMESPACE_END
#endif
