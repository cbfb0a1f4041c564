#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/shadow_bounds.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = SHADOW_BOUNDS_CASCADES_SLOT) uniform sampler2DArray cascades;
layout(set = 0, binding = SHADOW_BOUNDS_IMAGE_SLOT, rg32f) uniform image2D bounds_image;
layout(push_constant, scalar) uniform Push { ShadowBoundsPush push; };

vec2 joined(vec2 a, vec2 b) { return vec2(min(a.x, b.x), max(a.y, b.y)); }

// Beyond the cascade's edge: its last texels.
vec2 bounds_of_texels(ivec2 block, int cascade) {
    vec2 texel = 1.0 / vec2(textureSize(cascades, 0).xy), bounds = vec2(1.0, 0.0);
    for (int i = 0; i < SHADOW_BLOCK * SHADOW_BLOCK / 4; ++i) {
        vec2 at = vec2(block * SHADOW_BLOCK + 2 * ivec2(i % (SHADOW_BLOCK / 2), i / (SHADOW_BLOCK / 2)) + 1) * texel;
        vec4 four = textureGather(cascades, vec3(at, cascade));
        bounds = joined(bounds, vec2(min(min(four.x, four.y), min(four.z, four.w)), max(max(four.x, four.y), max(four.z, four.w))));
    }
    return bounds;
}

vec2 bounds_of_blocks(ivec2 block, int cascade) {
    ivec2 from = bounds_origin(push.side, push.level - 1, cascade) + 2 * block;
    vec2 low = joined(imageLoad(bounds_image, from).rg, imageLoad(bounds_image, from + ivec2(1, 0)).rg);
    return joined(low, joined(imageLoad(bounds_image, from + ivec2(0, 1)).rg, imageLoad(bounds_image, from + ivec2(1, 1)).rg));
}

void main() {
    int side = push.side >> push.level;
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    int cascade = block.y / side;
    block.y -= cascade * side;
    if (block.x >= side || cascade >= textureSize(cascades, 0).z) return;
    vec2 bounds = push.level == 0 ? bounds_of_texels(block, cascade) : bounds_of_blocks(block, cascade);
    imageStore(bounds_image, bounds_origin(push.side, push.level, cascade) + block, vec4(bounds, 0.0, 0.0));
}
