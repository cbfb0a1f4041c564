// A list of work that one pass fills and a later one works off, an invocation for each entry: software devices run both sides of
// a branch, and a list is how they are spared what only a few pixels want. For the same reason it keeps two kinds of work apart.
#ifndef ALPENGLOW_INTEROP_WORK_LIST_H
#define ALPENGLOW_INTEROP_WORK_LIST_H
#include "interop/language.h"

#define WORK_LIST_THREADS 128      // local_size_x of the pass that works it off
#define WORK_LIST_MOST_GROUPS 65535 // in a row, on any device

SHADER_NAMESPACE_BEGIN
struct WorkListHead {
    uint groups_x, groups_y, groups_z; // as vkCmdDispatchIndirect takes them
    uint count[2];                     // of each kind; entries follow
};
CHECK_SIZE(WorkListHead, 20);
SHADER_NAMESPACE_END

#endif
