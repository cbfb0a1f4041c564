// One text for GLSL and C++: what differs between the two languages, and nothing else.
// In shared text: pure functions, everything by parameter, `f` on literals, results through OUT(type), no swizzles.
#ifndef ALPENGLOW_INTEROP_LANGUAGE_H
#define ALPENGLOW_INTEROP_LANGUAGE_H

// Threads along each side of a compute pass's workgroup.
#define WORKGROUP_SIZE 8

#ifdef __cplusplus
#include <glm/glm.hpp>
#define INLINE inline
#define OUT(type) type&
#define SHADER_NAMESPACE_BEGIN namespace alpenglow::shader { using namespace glm;
#define SHADER_NAMESPACE_END }
#define CHECK_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), #type " is shared with GLSL in scalar layout")
#else
#define INLINE
#define OUT(type) out type
#define SHADER_NAMESPACE_BEGIN
#define SHADER_NAMESPACE_END
#define CHECK_SIZE(type, bytes)
#endif

#endif
