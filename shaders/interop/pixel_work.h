// Pass `pixel_work`: which pixels show a surface and which the sky, in blocks one pixel wide, as lists for the passes that deal with the
// ones or the others. An invocation a block.
#ifndef ALPENGLOW_INTEROP_PIXEL_WORK_H
#define ALPENGLOW_INTEROP_PIXEL_WORK_H
#include "interop/work_list.h"

#define PIXEL_WORK_ROWS 8 // of a block [pixels]

#define PIXEL_WORK_DEPTH_SLOT 0 // in, the G-buffer's
#define PIXEL_WORK_LIST_SLOT 1  // out: a block's column, and its row in the upper 16 bits; a block with both kinds is listed as both

#endif
