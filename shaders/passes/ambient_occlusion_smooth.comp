#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/ambient_occlusion.h"

// The mean over the 4 x 4 pixels that share out the directions, but for what lies at another depth.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = AMBIENT_OCCLUSION_NOISY_SLOT) uniform sampler2D noisy_image;
layout(binding = AMBIENT_OCCLUSION_NEAR_SLOT) uniform sampler2D depth_image;
layout(binding = AMBIENT_OCCLUSION_SMOOTH_SLOT, r32f) uniform writeonly image2D result;

const float SAME_DEPTH = 0.05; // relative

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    float depth = texelFetch(depth_image, pixel, 0).r;
    vec2 sum = vec2(texelFetch(noisy_image, pixel, 0).r, 1.0) * 1e-4;
    for (int i = 0; i < 16; ++i) {
        ivec2 at = clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), size - 1);
        float apart = abs(texelFetch(depth_image, at, 0).r - depth);
        float weight = clamp(2.0 - apart / (SAME_DEPTH * max(depth, 1e-30)), 0.0, 1.0);
        sum += weight * vec2(texelFetch(noisy_image, at, 0).r, 1.0);
    }
    imageStore(result, pixel, vec4(sum.x / sum.y));
}
