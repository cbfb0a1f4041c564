#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/shadow_bounds.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = SHADOW_BOUNDS_BLOCKS_SLOT) uniform sampler2D blocks;
layout(set = 0, binding = SHADOW_BOUNDS_IMAGE_SLOT, rg32f) uniform writeonly image2D bounds_image;

// The level that a row of the right part of the image belongs to, counted from the cascade's first.
int level_of_row(int side, int row) { return findMSB(side) - findMSB(max(side - row - 1, 1)); }

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = textureSize(blocks, 0);
    if (any(greaterThanEqual(texel, size))) return;
    int side = bounds_side(size.x), cascade = texel.y / side;
    int level = texel.x < side ? 0 : level_of_row(side, texel.y - cascade * side);
    ivec2 last = bounds_origin(side, level, cascade) + (side >> level) - 1;
    ivec2 next = min(texel + 1, max(last, texel));
    vec2 low = joined(texelFetch(blocks, texel, 0).rg, texelFetch(blocks, ivec2(next.x, texel.y), 0).rg);
    vec2 high = joined(texelFetch(blocks, ivec2(texel.x, next.y), 0).rg, texelFetch(blocks, next, 0).rg);
    imageStore(bounds_image, texel, vec4(joined(low, high), 0.0, 0.0));
}
