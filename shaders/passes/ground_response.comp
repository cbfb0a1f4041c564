#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/ground_response.glsl"
#include "interop/ground_light.h"

layout(set = 0, binding = GROUND_RESPONSE_BEFORE_SLOT) uniform sampler2D before_table;
layout(set = 0, binding = GROUND_RESPONSE_TABLE_SLOT, rgba32f) uniform image2D table;

#include "frame/moment_rounds.glsl"

void main() {
    Atmosphere atmosphere = frame.atmosphere;
    float altitude = ground_response_altitude(atmosphere, node().y);
    bool first = push.mode == GROUND_RESPONSE_STARTS;
    clear_sums();
    for (int i = int(gl_LocalInvocationIndex); i < gather_count(GROUND_RESPONSE_RAYS); i += THREADS) {
        GatherDirection direction = gather_direction(atmosphere, GROUND_RESPONSE_RAYS, altitude, 1.0, i);
        AirRay ray = make_air_ray(atmosphere.ground_radius, altitude, direction.mu, 1.0, direction.mu);
        add_direction(direction,
                      light_over_bright_ground(atmosphere, before_table, ray, GROUND_RESPONSE_RAYS.cells, first));
    }
    barrier();
    int channel = int(gl_LocalInvocationIndex);
    if (channel <= 2) store_round(channel, zonal_moments(summed_moments(channel)));
}
