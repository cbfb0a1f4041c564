// Pass `sky_irradiance`: the sky's irradiance on level ground, after `multiple_scattering`. A thread a texel.
#ifndef ALPENGLOW_INTEROP_SKY_IRRADIANCE_H
#define ALPENGLOW_INTEROP_SKY_IRRADIANCE_H
#include "interop/frame.h"

#define SKY_IRRADIANCE_FRAME_SLOT 0               // uniform buffer: FrameConstants
#define SKY_IRRADIANCE_TRANSMITTANCE_SLOT 1       // in, the transmittance table: linear filter, clamped to the edge
#define SKY_IRRADIANCE_MULTIPLE_SCATTERING_SLOT 2 // in, the multiple-scattering table: likewise
// Out, rgba32f, SKY_IRRADIANCE_WIDTH x SKY_IRRADIANCE_HEIGHT: rgb = 32nd root of irradiance per unit of solar irradiance.
#define SKY_IRRADIANCE_TABLE_SLOT 3

#endif
