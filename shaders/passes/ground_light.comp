#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/ground_response.glsl"
#include "interop/ground_light.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = GROUND_LIGHT_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = GROUND_LIGHT_ORDERS_SLOT) uniform sampler2D orders_table;
layout(set = 0, binding = GROUND_LIGHT_RESPONSE_SLOT) uniform sampler2D response_table;
layout(set = 0, binding = GROUND_LIGHT_TABLE_SLOT, rgba32f) uniform writeonly image2D table;
layout(push_constant, scalar) uniform Push { GroundLightPush push; };

ivec2 in_tile(ivec2 node, int tile) { return node + ivec2(0, tile * MULTIPLE_SCATTERING_HEIGHT); }

Moments moments_at(sampler2D from, ivec2 node, int channel) {
    Moments texels;
    for (int i = 0; i < LIGHT_PARTS; ++i) texels.part[i] = texelFetch(from, in_tile(node, LIGHT_PARTS * channel + i), 0);
    return unpacked_moments(texels);
}

void main() {
    Atmosphere atmosphere = frame.atmosphere;
    ivec2 node = ivec2(gl_GlobalInvocationID.xy), counts = ivec2(MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
    float mu_s = altitude_sun_from_uv(atmosphere, (vec2(node) + 0.5) / vec2(counts), counts.x, counts.y).y;
    vec3 difference = ground_difference(atmosphere, sunlight_table, orders_table, response_table, push.albedo,
                                        push.altitude, mu_s);
    for (int channel = 0; channel < 3; ++channel) {
        Moments light = moments_at(orders_table, node, channel);
        Moments response = moments_at(response_table, ivec2(0, node.y), channel);
        Moments sum = packed_moments(over_other_ground(light, response, difference[channel], mu_s));
        for (int i = 0; i < LIGHT_PARTS; ++i) imageStore(table, in_tile(node, LIGHT_PARTS * channel + i), sum.part[i]);
    }
}
