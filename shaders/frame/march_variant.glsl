// Which variant of the march a pass is: specialised, since software devices run both sides of a branch.
#ifndef ALPENGLOW_FRAME_MARCH_VARIANT
#define ALPENGLOW_FRAME_MARCH_VARIANT
#include "interop/models/march.h"

layout(constant_id = 0) const int MARCH_VARIANT = 0; // MARCH_…

#endif
