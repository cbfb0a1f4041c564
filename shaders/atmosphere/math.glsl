// Constants, and the few functions that GLSL lacks.
#ifndef ALPENGLOW_ATMOSPHERE_MATH_GLSL
#define ALPENGLOW_ATMOSPHERE_MATH_GLSL
#include "interop/language.h"
SHADER_NAMESPACE_BEGIN

CONSTANT float PI = 3.14159265358979f;
CONSTANT float GOLDEN_ANGLE = 2.39996322972865f; // [rad]
CONSTANT float TINY = 1e-30f;                    // keeps 0/0 at 0 and log(0) finite

// A number as the sum of two: `low` is what rounding took from `high`.
struct TwoFloat {
    float high, low;
};

// a + b: Knuth, The Art of Computer Programming, volume 2, section 4.2.2.
INLINE TwoFloat two_sum(float a, float b) {
    PRECISE float sum = a + b;
    PRECISE float from_b = sum - a;
    PRECISE float low = (a - (sum - from_b)) + (b - from_b);
    return TwoFloat(sum, low);
}

// a b: Dekker, A floating-point technique for extending the available precision, 1971. Factors below 1e16.
INLINE TwoFloat two_product(float a, float b) {
    PRECISE float product = a * b;
    PRECISE float wide_a = 4097.0f * a, wide_b = 4097.0f * b; // 2^12 + 1 halves the 24 digits
    PRECISE float a_high = wide_a - (wide_a - a), b_high = wide_b - (wide_b - b);
    PRECISE float a_low = a - a_high, b_low = b - b_high;
    PRECISE float low = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    return TwoFloat(product, low);
}

// (1 - exp(-x)) / x, for x >= 0: the mean transmittance inside a homogeneous layer of optical depth x. 1 at x = 0.
// Series below 1/8, where the difference would cancel; relative error 3e-7 in float. `through` is exp(-x).
INLINE float mean_transmittance_of(float x, float through) {
    float series = 1.0f - x * (1.0f / 2.0f) * (1.0f - x * (1.0f / 3.0f) * (1.0f - x * (1.0f / 4.0f) * (1.0f - x * 0.2f)));
    return x < 0.125f ? series : (1.0f - through) / max(x, 0.125f);
}

INLINE float mean_transmittance(float x) { return mean_transmittance_of(x, exp(-x)); }

INLINE vec3 mean_transmittance3(vec3 x) {
    return vec3(mean_transmittance(x.x), mean_transmittance(x.y), mean_transmittance(x.z));
}

// 1 - exp(-x) for x >= 0, accurate in its last digits when x is small.
INLINE float one_minus_exp(float x) { return x * mean_transmittance(x); }

// -log(1 - x) for 0 <= x < 1, accurate when x is small; series below 1/16.
INLINE float minus_log_one_minus(float x) {
    float series = x * (1.0f + x * (0.5f + x * (1.0f / 3.0f + x * (0.25f + x * (0.2f + x * (1.0f / 6.0f))))));
    return x < 0.0625f ? series : -log(1.0f - x);
}

// How tables hold what spans powers of ten: as its 32nd root. Linear interpolation of that follows an exponential as
// well as a logarithm does, and it comes back with five products in place of an exponential.
INLINE vec3 root32(vec3 x) { return sqrt(sqrt(sqrt(sqrt(sqrt(x))))); }
INLINE vec3 power32(vec3 x) {
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 x8 = x4 * x4;
    vec3 x16 = x8 * x8;
    return x16 * x16;
}

// Texture coordinate of x in [0, 1] on an axis of `size` texels whose first and last centres hold 0 and 1; and back.
INLINE float uv_from_unit(float x, int size) { return (0.5f + x * float(size - 1)) / float(size); }
INLINE float unit_from_uv(float uv, int size) { return (uv * float(size) - 0.5f) / float(size - 1); }

SHADER_NAMESPACE_END
#endif
