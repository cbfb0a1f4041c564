// Model `march`: what it reads.
#ifndef ALPENGLOW_INTEROP_MODELS_MARCH_H
#define ALPENGLOW_INTEROP_MODELS_MARCH_H
#include "interop/air_model.h"

#define MARCH_SUNLIGHT_SLOT (AIR_MODEL_SLOT + 0) // tables: linear filter, clamped to the edge
#define MARCH_MULTIPLE_SCATTERING_SLOT (AIR_MODEL_SLOT + 1)
#define MARCH_TRANSMITTANCE_SLOT (AIR_MODEL_SLOT + 2) // read by passes that draw rays

// Variants, added up; 0 has everything. Constants, since software devices run both sides of a branch.
#define MARCH_ONE_ORDER 1 // only light scattered once
#define MARCH_NO_SHAFTS 2 // no mesh shades the air
#define MARCH_EXACT 4     // shafts by even cells with one look each
#define MARCH_SOFT_SUN 8  // shafts of a disc

#endif
