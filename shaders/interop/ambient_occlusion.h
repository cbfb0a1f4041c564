// Passes `ambient_occlusion` and `ambient_occlusion_smooth`: the share of the light from all round that surfaces nearby leave. Both work off the pixels with surfaces.
#ifndef ALPENGLOW_INTEROP_AMBIENT_OCCLUSION_H
#define ALPENGLOW_INTEROP_AMBIENT_OCCLUSION_H
#include "interop/frame.h"

#define AMBIENT_OCCLUSION_NORMAL_SLOT 1 // in, the G-buffer: interop/gbuffer.h
#define AMBIENT_OCCLUSION_DEPTH_SLOT 2
#define AMBIENT_OCCLUSION_RESULT_SLOT 3 // out, r32f: 0 to 1, with the noise of few directions; cleared to 1
#define AMBIENT_OCCLUSION_TERRAIN_SLOT 4 // in, interop/terrain_light.h: linear filter, clamped to the edge

#define AMBIENT_OCCLUSION_WORK_SLOT 5    // in, of both: interop/pixel_work.h

#define AMBIENT_OCCLUSION_NOISY_SLOT 0 // in
#define AMBIENT_OCCLUSION_NEAR_SLOT 1  // in, depth
#define AMBIENT_OCCLUSION_SMOOTH_SLOT 2 // out, r32f: 0 to 1; cleared to 1

#endif
