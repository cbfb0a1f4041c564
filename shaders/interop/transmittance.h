// Pass `transmittance`: the table of optical depth to the top of the air, whenever the air changes. A thread a texel.
#ifndef ALPENGLOW_INTEROP_TRANSMITTANCE_H
#define ALPENGLOW_INTEROP_TRANSMITTANCE_H
#include "interop/frame.h"

// Out, rgba32f, TRANSMITTANCE_WIDTH x TRANSMITTANCE_HEIGHT: rgb = 32nd root of optical depth.
#define TRANSMITTANCE_TABLE_SLOT 1

#endif
