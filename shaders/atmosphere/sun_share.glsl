// How much of the sun's disc a straight edge leaves.
#ifndef ALPENGLOW_ATMOSPHERE_SUN_SHARE_GLSL
#define ALPENGLOW_ATMOSPHERE_SUN_SHARE_GLSL
#include "interop/language.h"
SHADER_NAMESPACE_BEGIN

// The share of a disc above a line, exactly 0 to exactly 1, where its centre stands x radii above it:
// 1/2 + (x sqrt(1 - x²) + asin x) / pi. The polynomial in y = (x + 1) / 2 is within 0.006 of it.
INLINE float disc_share_above(float x) {
    float y = clamp(0.5f + 0.5f * x, 0.0f, 1.0f);
    float bell = y * (1.0f - y);
    return y * y * (3.0f - 2.0f * y) + (1.0f - 2.0f * y) * bell * bell * (3.489f - 6.70f * bell);
}

SHADER_NAMESPACE_END
#endif
