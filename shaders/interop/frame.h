// What every pass of a frame may read: one uniform buffer, scalar layout.
#ifndef ALPENGLOW_INTEROP_FRAME_H
#define ALPENGLOW_INTEROP_FRAME_H
#include "interop/atmosphere.h"
SHADER_NAMESPACE_BEGIN

struct FrameConstants {
    Atmosphere atmosphere;
};

SHADER_NAMESPACE_END
#endif
