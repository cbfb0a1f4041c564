// Where the threads of a pass with a thread a texel stand in its table: workgroups row by row.
#ifndef ALPENGLOW_FRAME_TABLE_TEXEL
#define ALPENGLOW_FRAME_TABLE_TEXEL
#include "interop/air_tables.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(push_constant, scalar) uniform Push { AirTablePush push; };

// `width` of the table [texels], a multiple of the workgroup's.
ivec2 table_texel(int width) {
    int group = push.first_group + int(gl_WorkGroupID.x), across = width / WORKGROUP_SIZE;
    return WORKGROUP_SIZE * ivec2(group % across, group / across) + ivec2(gl_LocalInvocationID.xy);
}

#endif
