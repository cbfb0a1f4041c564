// The list of WORK_LIST_SLOT, which the includer defines. Work of the first kind is listed from its front, of the second from its end.
#ifndef ALPENGLOW_FRAME_WORK_LIST
#define ALPENGLOW_FRAME_WORK_LIST
#include "interop/work_list.h"

layout(set = 0, binding = WORK_LIST_SLOT, scalar) buffer WorkList {
    WorkListHead head;
    uint entries[];
} work_list;

uint work_place(uint kind, uint number) { return kind == SURFACE_WORK ? number : uint(work_list.entries.length()) - 1 - number; }

// What is beyond the list's end is not done.
void list_work(uint kind, uint entry) {
    uint number = atomicAdd(work_list.head.count[kind], 1);
    if (number >= uint(work_list.entries.length())) return;
    work_list.entries[work_place(kind, number)] = entry;
    if (number % WORK_LIST_THREADS != 0) return;
    uint group = number / WORK_LIST_THREADS;
    if (group < WORK_LIST_MOST_GROUPS) atomicAdd(work_list.head.groups[kind].x, 1);
    else if (group % WORK_LIST_MOST_GROUPS == 0) atomicAdd(work_list.head.groups[kind].y, 1);
}

// The entry of an invocation; false where there is none.
bool listed_work(uint kind, out uint entry) {
    uint group = gl_WorkGroupID.y * WORK_LIST_MOST_GROUPS + gl_WorkGroupID.x, number = group * WORK_LIST_THREADS + gl_LocalInvocationID.x;
    bool listed = number < min(work_list.head.count[kind], uint(work_list.entries.length()));
    entry = listed ? work_list.entries[work_place(kind, number)] : 0;
    return listed;
}

#endif
