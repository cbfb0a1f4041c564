// What the pass knows of the frame. Included before anything that reads it, which the air's shaders do.
#ifndef ALPENGLOW_FRAME_FRAME_BLOCK
#define ALPENGLOW_FRAME_FRAME_BLOCK
#include "interop/frame.h"

layout(set = 0, binding = FRAME_SLOT, scalar) uniform FrameBlock { FrameConstants frame; };

#endif
