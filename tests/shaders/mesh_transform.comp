#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "frame/mesh_transform.glsl"

// Clip coordinates of vertices, by the vertex shader's own arithmetic.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = 0) uniform sampler2D positions;
layout(binding = 1, rgba32f) uniform writeonly image2D result;
layout(push_constant, scalar) uniform Push { mat4 clip_from_relative; MeshDraw draw; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    imageStore(result, at, clip_from_relative * vec4(relative_from_mesh(draw, texelFetch(positions, at, 0).xyz), 1.0));
}
