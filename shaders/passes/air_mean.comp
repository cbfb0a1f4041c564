#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The mean luminance of the air's light over the rays that are marched first: what counts as faint and as bright in this picture.
// One workgroup, which adds in the same order in every run.
#include "encoding/color.glsl"
#include "interop/air.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = AIR_COARSE_INSCATTERED_SLOT) uniform sampler2D coarse_inscattered;
layout(set = 0, binding = AIR_MEAN_SLOT, rgba32f) uniform writeonly image2D mean_image;

const uint THREADS = WORKGROUP_SIZE * WORKGROUP_SIZE;
shared float sums[THREADS];

void main() {
    uint thread = gl_LocalInvocationIndex;
    ivec2 size = textureSize(coarse_inscattered, 0);
    float sum = 0.0;
    for (int y = 0; y < size.y; ++y)
        for (int x = int(thread); x < size.x; x += int(THREADS)) sum += luminance(texelFetch(coarse_inscattered, ivec2(x, y), 0).rgb);
    sums[thread] = sum;
    barrier();
    if (thread != 0) return;
    for (uint i = 1; i < THREADS; ++i) sum += sums[i];
    imageStore(mean_image, ivec2(0), vec4(sum / float(size.x * size.y), 0.0, 0.0, 0.0));
}
