// Passes `shadow_blocks` and `shadow_bounds`: least and greatest depth of blocks of each shadow cascade, from small blocks to the whole.
// Level k of a cascade has blocks of SHADOW_BLOCK << k texels. Level 0 stands at the left of the image, the others right of it,
// one below the other, and cascades below each other.
#ifndef ALPENGLOW_INTEROP_SHADOW_BOUNDS_H
#define ALPENGLOW_INTEROP_SHADOW_BOUNDS_H
#include "interop/language.h"

// shadow_blocks, level by level
#define SHADOW_BLOCKS_CASCADES_SLOT 0 // in: depth array, plain
#define SHADOW_BLOCKS_IMAGE_SLOT 1    // out, rg32f: least, greatest; read and written behind the first level

// shadow_bounds: of each block and those after it in x, in y and in both, so that one texel holds the bounds of whatever fits into a block
#define SHADOW_BOUNDS_BLOCKS_SLOT 0   // in
#define SHADOW_BOUNDS_IMAGE_SLOT 1    // out, rg32f

#define SHADOW_BLOCK 8 // [texels] side of the smallest blocks

SHADER_NAMESPACE_BEGIN
struct ShadowBlocksPush {
    int side;  // of level 0 in blocks, a power of two
    int level; // to make
};

// Where level `level` of a cascade begins in the image, for `side` blocks in level 0.
INLINE ivec2 bounds_origin(int side, int level, int cascade) {
    int y = level > 0 ? side - (side >> (level - 1)) : 0;
    return ivec2(level > 0 ? side : 0, cascade * side + y);
}

// The image's width for so many blocks along a side of level 0, and back.
INLINE int bounds_width(int side) { return side + (side + 1) / 2; }
INLINE int bounds_side(int width) { return width * 2 / 3; }

// Least and greatest of both.
INLINE vec2 joined(vec2 a, vec2 b) { return vec2(min(a.x, b.x), max(a.y, b.y)); }
SHADER_NAMESPACE_END

#endif
