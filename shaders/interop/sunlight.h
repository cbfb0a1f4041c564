// Pass `sunlight`: the table of the light of the sun's disc, after `transmittance`. A thread a texel.
#ifndef ALPENGLOW_INTEROP_SUNLIGHT_H
#define ALPENGLOW_INTEROP_SUNLIGHT_H
#include "interop/frame.h"

#define SUNLIGHT_TRANSMITTANCE_SLOT 1 // in: linear filter, clamped to the edge
#define SUNLIGHT_TABLE_SLOT 2         // out, rgba32f, shape of the other: atmosphere/sunlight.glsl

#endif
