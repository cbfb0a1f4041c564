// Unit vectors in two numbers from -1 to 1: the octahedral map (Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors", section 3).
#ifndef ALPENGLOW_ENCODING_OCTAHEDRAL
#define ALPENGLOW_ENCODING_OCTAHEDRAL
#include "interop/language.h"
SHADER_NAMESPACE_BEGIN

INLINE vec2 octahedral_from_unit(vec3 n) {
    float scale = 1.0f / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 p = vec2(n.x * scale, n.y * scale);
    vec2 folded = vec2((1.0f - abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f));
    return n.z >= 0.0f ? p : folded;
}

INLINE vec3 unit_from_octahedral(vec2 p) {
    vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0f);
    n.x += n.x >= 0.0f ? -fold : fold;
    n.y += n.y >= 0.0f ? -fold : fold;
    return normalize(n);
}

SHADER_NAMESPACE_END
#endif
