#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/shadow_ceiling.glsl"

// The share of the sun that reaches places in the sun's frame.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = 0) uniform sampler2D places;
layout(binding = 1, rgba32f) uniform writeonly image2D result;
layout(binding = 2) uniform sampler2D ceiling_map;
layout(push_constant, scalar) uniform Push { ShadowCeiling ceiling; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec3 light = texelFetch(places, at, 0).xyz;
    imageStore(result, at, vec4(ceiling_visibility(ceiling_map, ceiling, ceiling_place(ceiling, light)), 0.0, 0.0, 1.0));
}
