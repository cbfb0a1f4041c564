// One text for GLSL and C++: what differs between the two languages, and nothing else.
// In shared text: pure functions, everything by parameter, `f` on literals, results through OUT(type), no swizzles.
#ifndef ALPENGLOW_INTEROP_LANGUAGE_H
#define ALPENGLOW_INTEROP_LANGUAGE_H

#ifdef __cplusplus
#include <glm/glm.hpp>
#define INLINE inline
#define CONSTANT inline constexpr
#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE
#ifdef ALPENGLOW_SHADER_DOUBLE
#include "interop/language_double.h"
#else
#define SHADER_NAMESPACE_BEGIN namespace alpenglow::shader { using namespace glm;
#define CHECK_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), #type " is shared with GLSL in scalar layout")
#endif
#define SHADER_NAMESPACE_END }
#else
#define INLINE
#define CONSTANT const
#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise // evaluated as written: no rearranging
#define SHADER_NAMESPACE_BEGIN
#define SHADER_NAMESPACE_END
#define CHECK_SIZE(type, bytes)
#endif

// Side of a compute pass's square workgroup, in threads.
#define WORKGROUP_SIZE 8

SHADER_NAMESPACE_BEGIN

#ifdef __cplusplus
// What GLSL's type of this name gives to `sample_bilinear`: one level, rows from v = 0 on. Doesn't own its texels.
struct sampler2D {
    int width;
    int height;
    vec4 const* texels;
};

inline ivec2 textureSize(sampler2D const& image, int) { return {image.width, image.height}; }

// Bilinear, clamped to the edge; texel i's centre lies at (i + 0.5) / size.
inline vec4 sample_bilinear(sampler2D const& image, vec2 uv) {
    auto const x = clamp(uv.x * float(image.width) - 0.5f, 0.0f, float(image.width - 1));
    auto const y = clamp(uv.y * float(image.height) - 0.5f, 0.0f, float(image.height - 1));
    int const left = int(x), right = min(left + 1, image.width - 1);
    int const low = int(y), high = min(low + 1, image.height - 1);
    auto const at = [&image](int i, int j) { return image.texels[j * image.width + i]; };
    auto const row = [&](int j) { return mix(at(left, j), at(right, j), x - float(left)); };
    return mix(row(low), row(high), y - float(low));
}
#else
vec4 sample_bilinear(sampler2D image, vec2 uv) { return textureLod(image, uv, 0.0f); }
#endif

SHADER_NAMESPACE_END

#endif
