// The air in front of a pixel, from the images of the pass `air`, which the includer declares.
#ifndef ALPENGLOW_FRAME_AIR_LAYER
#define ALPENGLOW_FRAME_AIR_LAYER
#include "atmosphere/segment_integral.glsl"
#include "interop/frame_block.glsl"

AirLight air_before(ivec2 pixel) {
    if ((frame.flags & FRAME_AIR) == 0) return no_air_light();
    return AirLight(texelFetch(inscattered_image, pixel, 0).rgb, texelFetch(transmittance_image, pixel, 0).rgb);
}

#endif
