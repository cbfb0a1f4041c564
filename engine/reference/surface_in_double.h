#pragma once

// The description of surfaces, shaders/surface/brdf.glsl, with `float` read as `double`, in namespace
// alpenglow::shader_double: in single precision the narrowest lobes reflect 2 % too much. A file that includes this
// can't include the float compile.
#include <cmath>

#include <glm/glm.hpp>

#define ALPENGLOW_SHADER_DOUBLE
#define float double
#include "surface/brdf.glsl"
#undef float
