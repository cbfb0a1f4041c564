// A round of a table of moments: what a pass has gathered from `before_table` becomes the next state of `table`.
#ifndef ALPENGLOW_FRAME_MOMENT_ROUNDS
#define ALPENGLOW_FRAME_MOMENT_ROUNDS
#include "frame/node_moments.glsl"
#include "interop/multiple_scattering.h"

ChannelMoments moments_of(sampler2D from, int channel) {
    return unpacked_moments(ChannelMoments(texelFetch(from, tile_texel(2 * channel), 0),
                                           texelFetch(from, tile_texel(2 * channel + 1), 0)));
}

ChannelMoments oldest_moments(int channel) {
    return unpacked_moments(ChannelMoments(imageLoad(table, tile_texel(2 * channel)),
                                           imageLoad(table, tile_texel(2 * channel + 1))));
}

void store_round(int channel, ChannelMoments sum) {
    if (push.mode == MULTIPLE_SCATTERING_EXTRAPOLATES)
        sum = extrapolated_moments(oldest_moments(channel), moments_of(before_table, channel), sum);
    store_moments(channel, sum);
}

#endif
