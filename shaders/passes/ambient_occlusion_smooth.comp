#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/ambient_occlusion.h"
#include "interop/work_list.h"

// The mean over the 4 x 4 pixels that share out the directions, but for what lies at another depth.
layout(local_size_x = WORK_LIST_THREADS) in;
layout(binding = AMBIENT_OCCLUSION_NOISY_SLOT) uniform sampler2D noisy_image;
layout(binding = AMBIENT_OCCLUSION_NEAR_SLOT) uniform sampler2D depth_image;
layout(binding = AMBIENT_OCCLUSION_SMOOTH_SLOT, r32f) uniform writeonly image2D result;

#define WORK_LIST_SLOT AMBIENT_OCCLUSION_WORK_SLOT
#include "frame/pixel_work.glsl"

const float SAME_DEPTH = 0.05; // relative

void smooth_pixel(ivec2 pixel, ivec2 size, bool listed) {
    float depth = texelFetch(depth_image, pixel, 0).r;
    vec2 sum = vec2(texelFetch(noisy_image, pixel, 0).r, 1.0) * 1e-4;
    for (int i = 0; i < 16; ++i) {
        ivec2 at = clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), size - 1);
        float apart = abs(texelFetch(depth_image, at, 0).r - depth);
        float weight = clamp(2.0 - apart / (SAME_DEPTH * max(depth, 1e-30)), 0.0, 1.0);
        sum += weight * vec2(texelFetch(noisy_image, at, 0).r, 1.0);
    }
    if (listed && depth > 0.0) imageStore(result, pixel, vec4(sum.x / sum.y));
}

void main() {
    PixelBlock block = listed_block(SURFACE_WORK);
    ivec2 size = imageSize(result);
    int row = 0;
    do smooth_pixel(pixel_of(block, row, size), size, block.listed);
    while (++row < PIXEL_WORK_ROWS);
}
