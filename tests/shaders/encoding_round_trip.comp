#version 460
#extension GL_GOOGLE_include_directive : require
#include "encoding/color.glsl"
#include "encoding/octahedral.glsl"

// Encodings as the GPU computes them: of a unit vector in xyz, and of a linear value in w.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = 0) uniform sampler2D values;
layout(binding = 1, rgba32f) uniform writeonly image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec4 value = texelFetch(values, at, 0);
    imageStore(result, at, vec4(octahedral_from_unit(value.xyz), srgb_from_linear(value.w), linear_from_srgb(value.w)));
}
