#version 460
#extension GL_GOOGLE_include_directive : require
#include "encoding/octahedral.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = 0) uniform sampler2D values;
layout(binding = 1, rgba32f) uniform writeonly image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(result, at, vec4(unit_from_octahedral(texelFetch(values, at, 0).xy), 0.0));
}
