#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/shadow_ceiling.h"

// The highest that the sun's rays have met, column by column from the sunward edge on; a thread a column.
layout(local_size_x = CEILING_COLUMNS) in;
layout(binding = CEILING_HEIGHT_SLOT) uniform sampler2D heights;
layout(binding = CEILING_MAP_SLOT, rg32f) uniform writeonly image2D ceiling;
layout(push_constant, scalar) uniform Push { ShadowCeilingPush push; };

void main() {
    int column = int(gl_GlobalInvocationID.x);
    ivec2 size = textureSize(heights, 0);
    if (column >= size.x) return;
    vec2 caster = vec2(CEILING_NONE, 0.0);
    int row = 0;
    do {
        float depth = texelFetch(heights, ivec2(column, row), 0).r;
        float height = push.top - depth * push.range, u = push.sunward - float(row) * push.texel;
        float over = height * push.sun.x - u * push.sun.y;
        if (depth < 1.0 && over > caster.x) caster = vec2(over, u * push.sun.x + height * push.sun.y);
        imageStore(ceiling, ivec2(column, row), vec4(caster, 0.0, 0.0));
        ++row;
    } while (row < size.y);
}
