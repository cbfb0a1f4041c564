#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "atmosphere/transmittance.glsl"
#include "frame/table_texel.glsl"
#include "interop/transmittance.h"

layout(set = 0, binding = TRANSMITTANCE_TABLE_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = table_texel(TRANSMITTANCE_WIDTH);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(TRANSMITTANCE_WIDTH, TRANSMITTANCE_HEIGHT);
    vec2 node = transmittance_altitude_mu_from_uv(frame.atmosphere, uv);
    imageStore(table, texel, optical_depth_texel(compute_optical_depth_to_top(frame.atmosphere, node.x, node.y)));
}
