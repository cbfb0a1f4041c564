// present: the picture on the window, scaled to its size
#ifndef ALPENGLOW_INTEROP_PRESENT_H
#define ALPENGLOW_INTEROP_PRESENT_H
#include "interop/language.h"

#define PRESENT_PICTURE_SLOT 0 // sRGB-encoded

SHADER_NAMESPACE_BEGIN

struct PresentPush {
    int decode; // 1: the window encodes what is written, so write linear light
};

SHADER_NAMESPACE_END
#endif
