// Pass `air`: what the air in front of each pixel, or of one in so many, adds and lets through. Pass `air_repair`: the pixels between.
#ifndef ALPENGLOW_INTEROP_AIR_H
#define ALPENGLOW_INTEROP_AIR_H
#include "interop/air_model.h"
#include "interop/frame.h"

#define AIR_DEPTH_SLOT 1                 // in, the G-buffer's
#define AIR_SHADOW_SLOT 2                // in, cascades: depth array
#define AIR_INSCATTERED_SLOT 3           // out, rgba32f: radiance relative to the sun's irradiance [1/sr]
#define AIR_TRANSMITTANCE_SLOT 4         // out, rgba32f

#define AIR_SHADOW_BOUNDS_SLOT 7         // in: interop/shadow_bounds.h
#define AIR_CEILING_SLOT 8               // in: interop/shadow_ceiling.h

// air_repair, in: texel (i, j) holds pixel (i, j) * stride
#define AIR_COARSE_INSCATTERED_SLOT 5
#define AIR_COARSE_TRANSMITTANCE_SLOT 6

#define AIR_REPAIR_THREADS 32 // of a workgroup, which mends a square tile of pixels
#define AIR_REPAIR_TILE 32    // [pixels]

SHADER_NAMESPACE_BEGIN
struct AirPush {
    int stride;      // [pixels] from one marched pixel to the next
    float tolerance; // air_repair: of the air's light, and of what is behind it
};
SHADER_NAMESPACE_END
#endif
