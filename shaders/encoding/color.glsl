// Transfer functions with their inverses, luminance, and noise for dithering.
#ifndef ALPENGLOW_ENCODING_COLOR
#define ALPENGLOW_ENCODING_COLOR
#include "interop/language.h"
SHADER_NAMESPACE_BEGIN

// IEC 61966-2-1. Linear 0 to 1 and back.
INLINE float srgb_from_linear(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f; }
INLINE float linear_from_srgb(float x) { return x <= 0.04045f ? x / 12.92f : pow((x + 0.055f) / 1.055f, 2.4f); }

INLINE vec3 srgb_from_linear3(vec3 c) { return vec3(srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z)); }
INLINE vec3 linear_from_srgb3(vec3 c) { return vec3(linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z)); }

// Relative luminance of linear Rec.709 (ITU-R BT.709-6, section 3.2).
INLINE float luminance(vec3 linear) { return dot(linear, vec3(0.2126f, 0.7152f, 0.0722f)); }

// Interleaved gradient noise (Jimenez 2014), 0 to 1, by pixel.
INLINE float gradient_noise(vec2 pixel) { return fract(52.9829189f * fract(dot(pixel, vec2(0.06711056f, 0.00583715f)))); }

SHADER_NAMESPACE_END
#endif
