#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/color.glsl"
#include "encoding/metering.glsl"

// A histogram of the picture's luminance in parts: each workgroup counts its tiles in shared memory and stores a row. No
// two workgroups write one counter, so that nothing has to be cleared before and the counts are the same in every run.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = HISTOGRAM_LIT_SLOT) uniform sampler2D lit;
layout(binding = HISTOGRAM_COUNTS_SLOT, rgba32f) uniform writeonly image2D counts_image;

shared uint counts[HISTOGRAM_BINS];

void main() {
    uint thread = gl_LocalInvocationIndex;
    for (uint bin = thread; bin < HISTOGRAM_BINS; bin += WORKGROUP_SIZE * WORKGROUP_SIZE) counts[bin] = 0;
    barrier();

    ivec2 size = textureSize(lit, 0);
    ivec2 tiles = (size + WORKGROUP_SIZE - 1) / WORKGROUP_SIZE;
    int group = int(gl_WorkGroupID.y * HISTOGRAM_SIDE + gl_WorkGroupID.x);
    for (int tile = group; tile < tiles.x * tiles.y; tile += HISTOGRAM_SIDE * HISTOGRAM_SIDE) {
        ivec2 pixel = ivec2(tile % tiles.x, tile / tiles.x) * WORKGROUP_SIZE + ivec2(gl_LocalInvocationID.xy);
        if (all(lessThan(pixel, size))) atomicAdd(counts[histogram_bin(luminance(texelFetch(lit, pixel, 0).rgb))], 1);
    }
    barrier();

    uint first = 4 * thread;
    imageStore(counts_image, ivec2(thread, group), vec4(counts[first], counts[first + 1], counts[first + 2], counts[first + 3]));
}
