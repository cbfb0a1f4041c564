#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/metering.glsl"

// Adds up the histogram's parts, meters it, and lets the exposure follow. One workgroup.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = EXPOSURE_COUNTS_SLOT) uniform sampler2D counts_image;
layout(binding = EXPOSURE_STATE_SLOT, rgba32f) uniform image2D state_image;
layout(push_constant, scalar) uniform Push { ExposurePush push; };

shared vec4 counts[HISTOGRAM_BINS / 4];

void main() {
    uint thread = gl_LocalInvocationIndex;
    vec4 sum = vec4(0.0);
    for (int row = 0; row < HISTOGRAM_SIDE * HISTOGRAM_SIDE; ++row) sum += texelFetch(counts_image, ivec2(thread, row), 0);
    counts[thread] = sum;
    barrier();
    if (thread != 0) return;

    float pixels = -counts[0].x; // black ones are left out
    for (int i = 0; i < HISTOGRAM_BINS / 4; ++i) pixels += dot(counts[i], vec4(1.0));
    Metering metering = begin_metering(pixels);
    for (int bin = 1; bin < HISTOGRAM_BINS; ++bin) meter_bin(metering, bin, counts[bin / 4][bin % 4]);

    float metered = metered_stops(metering), target = exposure_for(metered, push);
    float before = imageLoad(state_image, ivec2(0)).y;
    float stops = adapted_exposure(before, target, push);
    imageStore(state_image, ivec2(0), vec4(exp2(stops), stops, target, metered));
}
