// The list of WORK_LIST_SLOT, which the includer defines. Work of the first kind is listed from its front, of the second from its end.
#ifndef ALPENGLOW_FRAME_WORK_LIST
#define ALPENGLOW_FRAME_WORK_LIST
#include "interop/work_list.h"

layout(set = 0, binding = WORK_LIST_SLOT, scalar) buffer WorkList {
    WorkListHead head;
    uint entries[];
} work_list;

uint work_place(uint kind, uint number) { return kind == 0 ? number : uint(work_list.entries.length()) - 1 - number; }

// What is beyond the list's end is not done.
void list_work(uint kind, uint entry) {
    uint number = atomicAdd(work_list.head.count[kind], 1);
    if (number >= uint(work_list.entries.length())) return;
    work_list.entries[work_place(kind, number)] = entry;
    if (number % WORK_LIST_THREADS == 0) atomicAdd(work_list.head.groups_x, 1);
}

// The entry of an invocation; false where there is none. Workgroups have work of one kind.
bool listed_work(uint group, uint thread, out uint entry) {
    uint most = uint(work_list.entries.length()), first_groups = (min(work_list.head.count[0], most) + WORK_LIST_THREADS - 1) / WORK_LIST_THREADS;
    uint kind = group < first_groups ? 0 : 1, number = (group - kind * first_groups) * WORK_LIST_THREADS + thread;
    bool listed = number < min(work_list.head.count[kind], most);
    entry = listed ? work_list.entries[work_place(kind, number)] : 0;
    return listed;
}

#endif
