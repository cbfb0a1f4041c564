// Sums over the directions of one node, which a workgroup shares. Included by passes that fill tables of moments, after
// `image2D table`.
#ifndef ALPENGLOW_FRAME_NODE_MOMENTS
#define ALPENGLOW_FRAME_NODE_MOMENTS
#include "atmosphere/multiple_scattering.glsl"
#include "interop/air_tables.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(push_constant, scalar) uniform Push { AirTablePush push; };

const int THREADS = WORKGROUP_SIZE * WORKGROUP_SIZE;
shared vec4 tile_sums[THREADS][LIGHT_TILES];

// Nodes of a tile.
ivec2 node_counts() { return imageSize(table) / ivec2(1, LIGHT_TILES); }

ivec2 node() {
    int group = push.first_group + int(gl_WorkGroupID.x), width = node_counts().x;
    return ivec2(group % width, group / width);
}

// x = altitude [m], y = mu_s of the workgroup's node.
vec2 node_altitude_sun(Atmosphere atmosphere) {
    ivec2 counts = node_counts();
    return altitude_sun_from_uv(atmosphere, (vec2(node()) + 0.5) / vec2(counts), counts.x, counts.y);
}

ivec2 tile_texel(int tile) { return node() + ivec2(0, tile * node_counts().y); }

void clear_sums() {
    for (int tile = 0; tile < LIGHT_TILES; ++tile) tile_sums[gl_LocalInvocationIndex][tile] = vec4(0.0);
}

void add_direction(GatherDirection direction, vec3 radiance) {
    Moments basis = gather_basis(direction);
    for (int channel = 0; channel < 3; ++channel) {
        float share = direction.weight * radiance[channel];
        for (int i = 0; i < LIGHT_PARTS; ++i) tile_sums[gl_LocalInvocationIndex][LIGHT_PARTS * channel + i] += basis.part[i] * share;
    }
}

// The workgroup's sums of a channel; for its first three threads, after a barrier.
Moments summed_moments(int channel) {
    Moments sum = no_moments();
    for (int thread = 0; thread < THREADS; ++thread)
        for (int i = 0; i < LIGHT_PARTS; ++i) sum.part[i] += tile_sums[thread][LIGHT_PARTS * channel + i];
    return sum;
}

void store_moments(int channel, Moments sum) {
    Moments moments = packed_moments(sum);
    for (int i = 0; i < LIGHT_PARTS; ++i) imageStore(table, tile_texel(LIGHT_PARTS * channel + i), moments.part[i]);
}

#endif
