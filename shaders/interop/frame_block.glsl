// What a pass knows of the frame.
#ifndef ALPENGLOW_INTEROP_FRAME_BLOCK
#define ALPENGLOW_INTEROP_FRAME_BLOCK
#include "interop/frame.h"

layout(set = 0, binding = FRAME_SLOT, scalar) uniform FrameBlock { FrameConstants frame; };

#endif
