// Passes `luminance_histogram` and `exposure`: how bright the picture is, and what it is multiplied by before the curve.
#ifndef ALPENGLOW_INTEROP_EXPOSURE_H
#define ALPENGLOW_INTEROP_EXPOSURE_H
#include "interop/language.h"

// luminance_histogram: HISTOGRAM_SIDE² workgroups count the pixels of every 8x8 tile that falls to them
#define HISTOGRAM_LIT_SLOT 0    // radiance
#define HISTOGRAM_COUNTS_SLOT 1 // out, rgba32f: a row for each workgroup, four bins in a texel
#define HISTOGRAM_SIDE 16
#define HISTOGRAM_BINS 256

// Bin 0 is darker than all others or black, the last is brighter than all others.
#define HISTOGRAM_LOWEST -30.0f // [stops] log2 of the luminance where bin 1 begins
#define HISTOGRAM_STEP 0.18f    // [stops]; up to 2^15.7, more than the sun's disc

// exposure: one workgroup
#define EXPOSURE_COUNTS_SLOT 0
#define EXPOSURE_STATE_SLOT 1   // updated, rgba32f, one texel: ExposureState

SHADER_NAMESPACE_BEGIN

struct ExposureState {
    float factor;  // radiance is multiplied by
    float stops;   // its logarithm
    float target;  // [stops] where the eye adapts to
    float metered; // [stops] log2 of the luminance that the exposure is made for
};
CHECK_SIZE(ExposureState, 16);

struct ExposurePush {
    float compensation; // [stops]
    float least;        // [stops]
    float most;         // [stops]
    float light_speed;  // [stops/s] towards a brighter picture's exposure
    float dark_speed;   // [stops/s] towards a darker one's
    float seconds;      // since the picture before; negative: adapted at once
};

SHADER_NAMESPACE_END
#endif
