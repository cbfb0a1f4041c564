// A round of a table of moments: what a pass has gathered from `before_table` becomes the next state of `table`.
#ifndef ALPENGLOW_FRAME_MOMENT_ROUNDS
#define ALPENGLOW_FRAME_MOMENT_ROUNDS
#include "frame/node_moments.glsl"
#include "interop/multiple_scattering.h"

Moments moments_of(sampler2D from, int channel) {
    Moments texels;
    for (int i = 0; i < LIGHT_PARTS; ++i) texels.part[i] = texelFetch(from, tile_texel(LIGHT_PARTS * channel + i), 0);
    return unpacked_moments(texels);
}

Moments oldest_moments(int channel) {
    Moments texels;
    for (int i = 0; i < LIGHT_PARTS; ++i) texels.part[i] = imageLoad(table, tile_texel(LIGHT_PARTS * channel + i));
    return unpacked_moments(texels);
}

void store_round(int channel, Moments sum) {
    if (push.mode == MULTIPLE_SCATTERING_EXTRAPOLATES)
        sum = extrapolated_moments(oldest_moments(channel), moments_of(before_table, channel), sum);
    store_moments(channel, sum);
}

#endif
