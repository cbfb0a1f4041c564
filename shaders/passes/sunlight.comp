#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "atmosphere/sunlight.glsl"
#include "frame/table_texel.glsl"
#include "interop/sunlight.h"

layout(set = 0, binding = SUNLIGHT_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;
layout(set = 0, binding = SUNLIGHT_TABLE_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = table_texel(TRANSMITTANCE_WIDTH);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT);
    vec2 node = transmittance_altitude_mu_from_uv(frame.atmosphere, uv);
    imageStore(table, texel, optical_depth_texel(compute_sunlight_depth(transmittance_table, frame.atmosphere, node.x, node.y)));
}
