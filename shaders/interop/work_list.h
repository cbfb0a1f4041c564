// A list of work that one pass fills and later ones work off, an invocation for each entry: software devices run both sides of
// a branch, and a list is how they are spared what only some pixels want. For the same reason it keeps two kinds of work apart,
// which are worked off each by a dispatch of its own.
#ifndef ALPENGLOW_INTEROP_WORK_LIST_H
#define ALPENGLOW_INTEROP_WORK_LIST_H
#include "interop/language.h"

#define SURFACE_WORK 0 // pixels that show a surface
#define SKY_WORK 1     // and those that don't
#define WORK_KINDS 2

#define WORK_LIST_THREADS 128       // local_size_x of a pass that works it off
#define WORK_LIST_MOST_GROUPS 65535 // in a row, on any device

SHADER_NAMESPACE_BEGIN
struct WorkGroups { // as vkCmdDispatchIndirect takes them
    uint x, y, z;
};
struct WorkListHead {
    WorkGroups groups[WORK_KINDS];
    uint count[WORK_KINDS]; // entries follow
};
CHECK_SIZE(WorkListHead, 32);
SHADER_NAMESPACE_END

#endif
