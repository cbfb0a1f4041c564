// Pass `multiple_scattering`: the table of light scattered twice and more, after `transmittance`. A thread a texel.
#ifndef ALPENGLOW_INTEROP_MULTIPLE_SCATTERING_H
#define ALPENGLOW_INTEROP_MULTIPLE_SCATTERING_H
#include "interop/frame.h"

#define MULTIPLE_SCATTERING_FRAME_SLOT 0         // uniform buffer: FrameConstants
#define MULTIPLE_SCATTERING_TRANSMITTANCE_SLOT 1 // in, the transmittance table: linear filter, clamped to the edge
// Out, rgba32f, MULTIPLE_SCATTERING_WIDTH x MULTIPLE_SCATTERING_HEIGHT: rgb = 32nd root of Psi, Psi in 1/sr per unit of solar irradiance.
#define MULTIPLE_SCATTERING_TABLE_SLOT 2

#endif
