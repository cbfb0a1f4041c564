// Pass `air`: what the air in front of each pixel, or of one in so many, adds and lets through. Passes `air_fill` and `air_repair`:
// of twice as many each way, by interpolation, and by marching where that will not do.
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
#define AIR_TERRAIN_SLOT 10              // in: interop/terrain_light.h, linear filter, clamped to the edge

// air_fill, in: with half as many texels each way; air_mean, in
#define AIR_COARSE_INSCATTERED_SLOT 5
#define AIR_COARSE_TRANSMITTANCE_SLOT 6

#define AIR_MEAN_SLOT 11                 // out of air_mean, in to air_fill; one texel, r: mean luminance of the rays marched first [1/sr]

#define AIR_FILL_ROWS 8                  // of coarse texels that an invocation of air_fill deals with

#define AIR_WORK_SLOT 9                  // texels that air_fill leaves to air_repair: x and y, 16 bits each; rays that end on a
                                         // surface, mostly inside the cascades, and rays that lead out of the air

SHADER_NAMESPACE_BEGIN
struct AirPush {
    int stride;      // [pixels] from one texel to the next: texel (i, j) holds pixel (i, j) * stride
    float tolerance; // air_fill: of the air's light, and of what is behind it
    int kind;        // air_repair: of the work, interop/work_list.h
};
SHADER_NAMESPACE_END
#endif
