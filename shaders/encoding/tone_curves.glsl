// Tone curves: from exposed radiance, linear and 0 or more, to the linear light of a display, 0 to 1. All start at 0 and
// never fall. Each channel by itself, unless a curve says otherwise.
#ifndef ALPENGLOW_ENCODING_TONE_CURVES
#define ALPENGLOW_ENCODING_TONE_CURVES
#include "encoding/color.glsl"
#include "interop/display.h"
SHADER_NAMESPACE_BEGIN

// 1 - exp(-x): Fernandez Arenas, figure 13.
INLINE vec3 exponential_curve(vec3 x) { return vec3(1.0f) - exp(-x); }

// x / (1 + x): Reinhard et al., Photographic Tone Reproduction for Digital Images, 2002, equation 3.
INLINE vec3 reinhard_curve(vec3 x) { return x / (vec3(1.0f) + x); }

// The rational fit of the ACES reference rendering for Rec.709 displays by Narkowicz (2015). White from 7.24 on.
INLINE vec3 aces_curve(vec3 x) {
    return min((x * (2.51f * x + vec3(0.03f))) / (x * (2.43f * x + vec3(0.59f)) + vec3(0.14f)), vec3(1.0f));
}

// The ACES fit with its author's exposure factor of 0.6 and a touch of desaturation towards white, which keeps hues.
INLINE vec3 filmic_curve(vec3 x) {
    float grey = luminance(x);
    float bleach = grey / (grey + 4.0f); // tuned: the sun's surroundings go white instead of yellow-green
    return aces_curve(mix(x, vec3(grey), 0.5f * bleach) * 0.6f);
}

// x^a / (b x^(a d) + c): Lottes, Advanced Techniques and Optimization of HDR Color Pipelines, GDC 2016, with contrast
// a = 1.6 and shoulder d = 0.977. b and c solve f(0.18) = 0.267 and f(8) = 1.
INLINE vec3 lottes_curve(vec3 x) {
    const float a = 1.6f, ad = 1.5632f, b = 1.07303971f, c = 0.167419938f;
    return min(pow(x, vec3(a)) / (pow(x, vec3(ad)) * b + vec3(c)), vec3(1.0f));
}

// Uchimura, HDR theory and practice, CEDEC 2017, with his parameters for a display of peak P = 1: a toe of power 1.33 up
// to m = 0.22, a line of slope 1 over 0.4 of the rest, an exponential shoulder.
INLINE vec3 uchimura_curve(vec3 x) {
    const float m = 0.22f, shoulder = 0.532f; // m + 0.4 (P - m): where the line ends
    vec3 toe = m * pow(x / m, vec3(1.33f));
    vec3 end = vec3(1.0f) - (1.0f - shoulder) * exp((vec3(shoulder) - x) / (1.0f - shoulder));
    vec3 low = vec3(1.0f) - smoothstep(vec3(0.0f), vec3(m), x);
    vec3 high = step(vec3(shoulder), x);
    return toe * low + x * (vec3(1.0f) - low - high) + end * high;
}

// AgX's sigmoid, 0 to 1, both: a line of slope 2 through the pivot, bent to 0 and to 1 by powers 3 and 3.25.
INLINE float agx_sigmoid(float x) {
    const float pivot = 0.606060606f; // middle grey: 10 of 16.5 stops
    float bend = x < pivot ? pow(1.0f + 59.507875f * pow(pivot - x, 3.0f), -1.0f / 3.0f)
                           : pow(1.0f + 69.8627891f * pow(x - pivot, 3.25f), -4.0f / 13.0f);
    return 0.5f + 2.0f * (x - pivot) * bend;
}

// After T. Sobotka's AgX (2022; base look, Rec.709): each channel is moved a fifth of the way to a weighted mean of the
// three, through a sigmoid of its logarithm, 10 stops below to 6.5 above middle grey, and back by the same fifth. His
// tables are for displays of gamma 2.2. Bright colours fade to white instead of to the nearest primary.
INLINE vec3 agx_curve(vec3 x) {
    const float fifth = 0.2f, lowest = -12.4739312f, stops = 16.5f;
    const vec3 weights = vec3(0.212005355f, 0.392182508f, 0.395812137f);
    vec3 inset = mix(x, vec3(dot(x, weights)), fifth);
    vec3 place = clamp((log2(max(inset, vec3(1e-9f))) - vec3(lowest)) / stops, vec3(0.0f), vec3(1.0f));
    vec3 bent = vec3(agx_sigmoid(place.x), agx_sigmoid(place.y), agx_sigmoid(place.z));
    vec3 outset = (bent - fifth * vec3(dot(bent, weights))) / (1.0f - fifth);
    return pow(clamp(outset, vec3(0.0f), vec3(1.0f)), vec3(2.2f));
}

// `curve` of interop/display.h. Powers are dear where a device runs all cases: give it a constant.
INLINE vec3 tone_curve(int curve, vec3 exposed) {
    vec3 x = min(exposed, vec3(1e6f)); // white long before; powers stay finite
    switch (curve) {
    case CURVE_FILMIC: return filmic_curve(x);
    case CURVE_EXPONENTIAL: return exponential_curve(x);
    case CURVE_REINHARD: return reinhard_curve(x);
    case CURVE_ACES: return aces_curve(x);
    case CURVE_LOTTES: return lottes_curve(x);
    case CURVE_UCHIMURA: return uchimura_curve(x);
    case CURVE_AGX: return agx_curve(x);
    default: return clamp(x, vec3(0.0f), vec3(1.0f)); // linear
    }
}

SHADER_NAMESPACE_END
#endif
