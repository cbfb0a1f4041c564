#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/multiple_scattering.h"

layout(set = 0, binding = FIRST_ORDER_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = FIRST_ORDER_TABLE_SLOT, rgba32f) uniform writeonly image2D table;

#include "frame/node_moments.glsl"

void main() {
    Atmosphere atmosphere = frame.atmosphere;
    vec2 place = node_altitude_sun(atmosphere);
    clear_sums();
    int i = int(gl_LocalInvocationIndex);
    do {
        GatherDirection direction = gather_direction(atmosphere, FIRST_ORDER_RAYS, place.x, place.y, i);
        AirRay ray = make_air_ray(atmosphere.ground_radius, place.x, direction.mu, place.y, direction.sunward.nu);
        add_direction(direction, first_order_light(atmosphere, sunlight_table, ray, FIRST_ORDER_RAYS.cells));
        i += THREADS;
    } while (i < gather_count(FIRST_ORDER_RAYS));
    barrier();
    int channel = int(gl_LocalInvocationIndex);
    if (channel <= 2) store_moments(channel, summed_moments(channel));
}
