// The blocks of pixels that the pass `pixel_work` listed. Included by passes that work them off and define WORK_LIST_SLOT.
#ifndef ALPENGLOW_FRAME_PIXEL_WORK
#define ALPENGLOW_FRAME_PIXEL_WORK
#include "frame/work_list.glsl"
#include "interop/pixel_work.h"

// Its pixels may be of the other kind too.
struct PixelBlock {
    ivec2 first;
    bool listed;
};

PixelBlock listed_block(uint kind) {
    uint entry;
    bool listed = listed_work(kind, entry);
    return PixelBlock(ivec2(entry & 0xffffu, (entry >> 16) * PIXEL_WORK_ROWS), listed);
}

// At the picture's end the last pixel again and again.
ivec2 pixel_of(PixelBlock block, int row, ivec2 size) { return min(block.first + ivec2(0, row), size - 1); }

#endif
