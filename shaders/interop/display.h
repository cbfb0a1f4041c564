// Passes on whole pictures, behind the lighting.
#ifndef ALPENGLOW_INTEROP_DISPLAY_H
#define ALPENGLOW_INTEROP_DISPLAY_H
#include "interop/language.h"

// accumulate: adds a supersample to two means, of its radiance and of what the tone curve makes of it
#define ACCUMULATE_LIT_SLOT 0
#define ACCUMULATE_MEAN_SLOT 1  // rgba32f, updated: linear radiance
#define ACCUMULATE_TONED_SLOT 2 // rgba32f, updated: behind exposure and curve, 0 to 1
#define ACCUMULATE_EXPOSURE_SLOT 3 // interop/exposure.h

// display: what is seen to 8 bits
#define DISPLAY_SOURCE_SLOT 0
#define DISPLAY_PICTURE_SLOT 1  // rgba8, sRGB-encoded

// post_aa: FXAA on the encoded picture
#define POST_AA_PICTURE_SLOT 0
#define POST_AA_RESULT_SLOT 1

// show: any image of the frame
#define SHOW_IMAGE_SLOT 0       // sampler2DArray
#define SHOW_PICTURE_SLOT 1
#define SHOW_EXPOSURE_SLOT 2    // interop/exposure.h

// Tone curves, encoding/tone_curves.glsl: the variants of the passes that have one.
#define CURVE_FILMIC 0
#define CURVE_EXPONENTIAL 1
#define CURVE_REINHARD 2
#define CURVE_ACES 3
#define CURVE_LOTTES 4
#define CURVE_UCHIMURA 5
#define CURVE_AGX 6
#define CURVE_LINEAR 7
#define CURVE_COUNT 8

SHADER_NAMESPACE_BEGIN

struct AccumulatePush {
    int sample_index; // of the supersamples; 0 starts anew
    int samples;
};

struct DisplayPush {
    int dither; // 0 or 1
};

struct ShowPush {
    int scale;        // ShowScale
    int layers;       // shown side by side
    float near_plane; // [m]
};

SHADER_NAMESPACE_END
#endif
