#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/sky_irradiance.glsl"
#include "interop/sky_irradiance.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = SKY_IRRADIANCE_FRAME_SLOT, scalar) uniform Frame { FrameConstants frame; };
layout(set = 0, binding = SKY_IRRADIANCE_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;
layout(set = 0, binding = SKY_IRRADIANCE_MULTIPLE_SCATTERING_SLOT) uniform sampler2D multiple_scattering_table;
layout(set = 0, binding = SKY_IRRADIANCE_TABLE_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT);
    vec2 node = altitude_sun_from_uv(frame.atmosphere, uv, SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT);
    vec3 irradiance =
        compute_sky_irradiance(frame.atmosphere, transmittance_table, multiple_scattering_table, node.x, node.y);
    imageStore(table, texel, sky_irradiance_texel(irradiance));
}
