#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/shadow_ceiling.h"

// The highest that the sun's rays have met, column by column from the sunward edge on; a thread a column.
layout(local_size_x = CEILING_COLUMNS) in;
layout(binding = CEILING_HEIGHT_SLOT) uniform sampler2D heights;
layout(binding = CEILING_MAP_SLOT, rg32f) uniform writeonly image2D ceiling;
layout(push_constant, scalar) uniform Push { ShadowCeilingPush push; };

// (over, along) of the terrain in a row.
vec2 terrain_at(int column, int row, int rows) {
    float depth = texelFetch(heights, ivec2(column, min(row, rows - 1)), 0).r;
    float height = push.top - depth * push.range, u = push.sunward - float(row) * push.texel;
    vec2 place = vec2(height * push.sun.x - u * push.sun.y, u * push.sun.x + height * push.sun.y);
    return depth < 1.0 ? place : vec2(CEILING_NONE, 0.0);
}

// A crest lies between rows and is higher than both: where the slopes on its two sides meet, each the gentler of the
// last two, so that walls don't count as slopes. `over` of six rows; `none` where no crest lies between the third and
// the fourth.
float crest_between(float r0, float r1, float r2, float r3, float r4, float r5, float none) {
    float rise = min(r2 - r1, r1 - r0), fall = min(r3 - r4, r4 - r5);
    float share = (r3 + fall - r2) / max(rise + fall, 1e-6);
    bool known = min(r0, r5) > CEILING_NONE && rise > 0.0 && fall > 0.0 && share > 0.0 && share < 1.0;
    return known ? r2 + rise * share : none;
}

void main() {
    int column = int(gl_GlobalInvocationID.x);
    ivec2 size = textureSize(heights, 0);
    if (column >= size.x) return;
    vec2 caster = vec2(CEILING_NONE, 0.0);
    float r0 = CEILING_NONE, r1 = r0, r2 = r0;
    vec2 here = terrain_at(column, 0, size.y);
    vec2 next = terrain_at(column, 1, size.y), after = terrain_at(column, 2, size.y);
    int row = 0;
    do {
        float highest = max(here.x, crest_between(r0, r1, r2, here.x, next.x, after.x, CEILING_NONE));
        if (highest > caster.x) caster = vec2(highest, here.y);
        imageStore(ceiling, ivec2(column, row), vec4(caster, 0.0, 0.0));
        ++row;
        r0 = r1;
        r1 = r2;
        r2 = here.x;
        here = next;
        next = after;
        after = terrain_at(column, row + 2, size.y);
    } while (row < size.y);
}
