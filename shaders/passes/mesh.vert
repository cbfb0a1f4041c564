#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "frame/mesh_transform.glsl"

// A mesh in the view or in a cascade.
layout(push_constant, scalar) uniform Push { MeshDraw draw; };

layout(location = VERTEX_POSITION) in vec3 position;
layout(location = VERTEX_NORMAL) in vec4 normal;
layout(location = VERTEX_TANGENT) in vec4 tangent;
layout(location = VERTEX_UV) in vec4 uv;
layout(location = VERTEX_COLOR) in vec4 color;

layout(location = 0) out vec3 out_relative; // world axes, from the camera [m]
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_color;

void main() {
    vec3 relative = relative_from_mesh(draw, position);
    gl_Position = frame.clip_from_relative[draw.projection] * vec4(relative, 1.0);
    // Normals of a mesh that is scaled or mirrored: the cofactor matrix.
    mat3 m = draw.world_from_mesh;
    mat3 cofactor = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * sign(determinant(m));
    out_relative = relative;
    out_normal = normalize(cofactor * normal.xyz);
    out_tangent = vec4(m * tangent.xyz, tangent.w);
    out_uv = uv;
    out_color = color;
}
