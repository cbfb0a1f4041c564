#pragma once

// The text of shaders/atmosphere once more, with `float` read as `double`, in namespace alpenglow::shader_double. A
// file that includes this can't include the float compile as well.
#include <cmath>

#include <glm/glm.hpp>

#define ALPENGLOW_SHADER_DOUBLE
#define float double
#include "atmosphere/inscattering.glsl"
#undef float
