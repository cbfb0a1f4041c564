#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/multiple_scattering.glsl"
#include "interop/multiple_scattering.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = MULTIPLE_SCATTERING_FRAME_SLOT, scalar) uniform Frame { FrameConstants frame; };
layout(set = 0, binding = MULTIPLE_SCATTERING_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;
layout(set = 0, binding = MULTIPLE_SCATTERING_TABLE_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
    vec2 node = altitude_sun_from_uv(frame.atmosphere, uv, MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
    vec3 psi = compute_multiple_scattering(frame.atmosphere, transmittance_table, node.x, node.y);
    imageStore(table, texel, multiple_scattering_texel(psi));
}
