// Model `march`: what its lighting pass reads.
#ifndef ALPENGLOW_INTEROP_MODELS_MARCH_H
#define ALPENGLOW_INTEROP_MODELS_MARCH_H
#include "interop/lighting.h"

#define MARCH_TRANSMITTANCE_SLOT (LIGHTING_MODEL_SLOT + 0)       // tables: linear filter, clamped to the edge
#define MARCH_MULTIPLE_SCATTERING_SLOT (LIGHTING_MODEL_SLOT + 1)

// Variants: which orders of scattering a ray brings. A constant, since software devices run both sides of a branch.
#define MARCH_ALL_ORDERS 0
#define MARCH_ONE_ORDER 1

#endif
