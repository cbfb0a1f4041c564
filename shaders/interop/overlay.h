// overlay: flat triangles over the window's picture
#ifndef ALPENGLOW_INTEROP_OVERLAY_H
#define ALPENGLOW_INTEROP_OVERLAY_H
#include "interop/language.h"

#define OVERLAY_TEXTURE_SLOT 0

// Vertex attributes
#define OVERLAY_PLACE 0 // [points] from the upper left corner
#define OVERLAY_UV 1
#define OVERLAY_COLOR 2 // sRGB-encoded, straight alpha

SHADER_NAMESPACE_BEGIN

struct OverlayPush {
    vec2 ndc_from_points;
    int decode; // as PresentPush
};

SHADER_NAMESPACE_END
#endif
