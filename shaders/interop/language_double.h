// The second C++ compile of the shared text, in double precision, for tests and the path tracer:
// `tests/support/air_in_double.h` and `engine/reference/surface_scattering.cpp` turn `float` into `double` around it.
// Literals stay float, so GLM's templates need the scalar functions once more.
#ifndef ALPENGLOW_INTEROP_LANGUAGE_DOUBLE_H
#define ALPENGLOW_INTEROP_LANGUAGE_DOUBLE_H

namespace alpenglow::shader_double {
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline int max(int a, int b) { return a > b ? a : b; }
inline int min(int a, int b) { return a < b ? a : b; }
inline double clamp(double x, double low, double high) { return min(max(x, low), high); }
inline double mix(double a, double b, double x) { return a + (b - a) * x; }
inline vec3 operator*(double a, vec3 const& b) { return vec3(a * b.x, a * b.y, a * b.z); }
inline vec3 operator*(vec3 const& a, double b) { return b * a; }
using glm::clamp;
using glm::max;
using glm::min;
using glm::mix;
} // namespace alpenglow::shader_double

#define SHADER_NAMESPACE_BEGIN                                                                                         \
    namespace alpenglow::shader_double {                                                                               \
    using namespace glm;
#define CHECK_SIZE(type, bytes) static_assert(sizeof(type) > 0)

#endif
