#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/pixel_work.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = PIXEL_WORK_DEPTH_SLOT) uniform sampler2D depth_image;

#define WORK_LIST_SLOT PIXEL_WORK_LIST_SLOT
#include "frame/work_list.glsl"

void main() {
    ivec2 size = textureSize(depth_image, 0), block = ivec2(gl_GlobalInvocationID.xy), first = block * ivec2(1, PIXEL_WORK_ROWS);
    if (any(greaterThanEqual(first, size))) return;
    float nearest = 0.0, farthest = 1.0;
    for (int row = 0; row < PIXEL_WORK_ROWS; ++row) {
        float depth = texelFetch(depth_image, ivec2(first.x, min(first.y + row, size.y - 1)), 0).r;
        nearest = max(nearest, depth);
        farthest = min(farthest, depth);
    }
    uint entry = uint(block.x) | uint(block.y) << 16;
    if (nearest > 0.0) list_work(SURFACE_WORK, entry);
    if (farthest <= 0.0) list_work(SKY_WORK, entry);
}
