#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/multiple_scattering.h"

layout(set = 0, binding = MULTIPLE_SCATTERING_FIRST_ORDER_SLOT) uniform sampler2D first_order_table;
layout(set = 0, binding = MULTIPLE_SCATTERING_BEFORE_SLOT) uniform sampler2D before_table;
layout(set = 0, binding = MULTIPLE_SCATTERING_TABLE_SLOT, rgba32f) uniform image2D table;

#include "frame/moment_rounds.glsl"

void main() {
    Atmosphere atmosphere = frame.atmosphere;
    vec2 place = node_altitude_sun(atmosphere);
    clear_sums();
    int i = int(gl_LocalInvocationIndex);
    do { // frame/air_march.glsl tells why loops test at their end
        GatherDirection direction = gather_direction(atmosphere, HIGHER_ORDER_RAYS, place.x, place.y, i);
        AirRay ray = make_air_ray(atmosphere.ground_radius, place.x, direction.mu, place.y, direction.sunward.nu);
        add_direction(direction, scattered_light(atmosphere, before_table, ray, HIGHER_ORDER_RAYS.cells));
        i += THREADS;
    } while (i < gather_count(HIGHER_ORDER_RAYS));
    barrier();
    int channel = int(gl_LocalInvocationIndex);
    if (channel > 2) return;
    store_round(channel, sum_of(moments_of(first_order_table, channel), summed_moments(channel)));
}
