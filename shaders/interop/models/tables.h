// Model `tables`: its tables, the passes that fill them, and what it reads.
#ifndef ALPENGLOW_INTEROP_MODELS_TABLES_H
#define ALPENGLOW_INTEROP_MODELS_TABLES_H
#include "interop/air_model.h"

// Sizes as Hillaire 2020 has them, in texels.
#define ISOTROPIC_SIZE 32            // a side: sun zenith, altitude
#define SKY_LIGHT_WIDTH 64           // sun zenith
#define SKY_LIGHT_HEIGHT 16          // altitude
#define SKY_VIEW_WIDTH 192           // azimuth from the sun
#define SKY_VIEW_HEIGHT 108          // zenith angle, dense at the horizon
#define AERIAL_SIZE 32               // a side of a slice: the picture
#define AERIAL_SLICES 32             // beside each other; the lower half of the image holds the transmittance

#define TABLES_SUNLIGHT_SLOT (AIR_MODEL_SLOT + 0)
#define TABLES_ISOTROPIC_SLOT (AIR_MODEL_SLOT + 1)
#define TABLES_SKY_LIGHT_SLOT (AIR_MODEL_SLOT + 2)
#define TABLES_SKY_VIEW_SLOT (AIR_MODEL_SLOT + 3)
#define TABLES_AERIAL_SLOT (AIR_MODEL_SLOT + 4)
#define TABLES_TRANSMITTANCE_SLOT (AIR_MODEL_SLOT + 5)

// The passes, a thread a texel, `aerial_perspective` a thread a column of slices. They all read the tables made before
// them: linear filter, clamped to the edge.
#define TABLE_SUNLIGHT_SLOT 1        // in
#define TABLE_ISOTROPIC_SLOT 2       // in; not read by the pass that makes it
#define TABLE_RESULT_SLOT 3          // out, rgba32f

#endif
