// Passes on whole pictures, behind the lighting.
#ifndef ALPENGLOW_INTEROP_DISPLAY_H
#define ALPENGLOW_INTEROP_DISPLAY_H
#include "interop/language.h"

// accumulate: adds a supersample to the mean
#define ACCUMULATE_LIT_SLOT 0
#define ACCUMULATE_MEAN_SLOT 1  // rgba32f, updated

// display: radiance to 8 bits
#define DISPLAY_RADIANCE_SLOT 0
#define DISPLAY_PICTURE_SLOT 1  // rgba8, sRGB-encoded

// post_aa: FXAA on the encoded picture
#define POST_AA_PICTURE_SLOT 0
#define POST_AA_RESULT_SLOT 1

// show: any image of the frame
#define SHOW_IMAGE_SLOT 0       // sampler2DArray
#define SHOW_PICTURE_SLOT 1

#define CURVE_EXPONENTIAL 0
#define CURVE_FILMIC 1

SHADER_NAMESPACE_BEGIN

struct AccumulatePush {
    int sample_index; // of the supersamples; 0 starts anew
    int samples;
};

struct DisplayPush {
    float exposure;   // factor
    int curve;        // CURVE_…
    int dither;       // 0 or 1
};

struct ShowPush {
    float exposure;
    int curve;
    int scale;        // ShowScale
    int layers;       // shown side by side
    float near_plane; // [m]
};

SHADER_NAMESPACE_END
#endif
