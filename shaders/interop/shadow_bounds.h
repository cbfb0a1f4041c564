// Pass `shadow_bounds`: least and greatest depth of blocks of each shadow cascade, from small blocks to the whole.
// Level k of a cascade has blocks of SHADOW_BLOCK << k texels. Level 0 stands at the left of the image, the others right of it,
// one below the other, and cascades below each other.
#ifndef ALPENGLOW_INTEROP_SHADOW_BOUNDS_H
#define ALPENGLOW_INTEROP_SHADOW_BOUNDS_H
#include "interop/language.h"

#define SHADOW_BOUNDS_CASCADES_SLOT 0 // in: depth array, plain
#define SHADOW_BOUNDS_IMAGE_SLOT 1    // out, rg32f: least, greatest; read and written behind the first level

#define SHADOW_BLOCK 8 // [texels] side of the smallest blocks

SHADER_NAMESPACE_BEGIN
struct ShadowBoundsPush {
    int side;  // of level 0 in blocks, a power of two
    int level; // to make
};

// Where level `level` of a cascade begins in the image, for `side` blocks in level 0.
INLINE ivec2 bounds_origin(int side, int level, int cascade) {
    int y = level > 0 ? side - (side >> (level - 1)) : 0;
    return ivec2(level > 0 ? side : 0, cascade * side + y);
}
SHADER_NAMESPACE_END

#endif
