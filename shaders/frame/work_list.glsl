// The list of WORK_LIST_SLOT, which the includer defines.
#ifndef ALPENGLOW_FRAME_WORK_LIST
#define ALPENGLOW_FRAME_WORK_LIST
#include "interop/work_list.h"

layout(set = 0, binding = WORK_LIST_SLOT, scalar) buffer WorkList {
    WorkListHead head;
    uint entries[];
} work_list;

// What is beyond the list's end is not done.
void list_work(uint entry) {
    uint place = atomicAdd(work_list.head.count, 1);
    if (place >= uint(work_list.entries.length())) return;
    work_list.entries[place] = entry;
    if (place % WORK_LIST_THREADS == 0) atomicAdd(work_list.head.groups_x, 1);
}

#endif
