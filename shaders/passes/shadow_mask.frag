#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "frame/mesh_material.glsl"

// A cut-out material in a shadow cascade: holes let the sun through.
layout(location = 3) in vec4 uv;
layout(location = 4) in vec4 color;

void main() {
    if (cut_out(base_color_at(uv, color, 0.0).a)) discard;
}
