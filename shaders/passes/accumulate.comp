#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/display.h"

// The running mean of the supersamples' radiance.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = ACCUMULATE_LIT_SLOT) uniform sampler2D lit;
layout(binding = ACCUMULATE_MEAN_SLOT, rgba32f) uniform image2D mean;
layout(push_constant, scalar) uniform Push { AccumulatePush push; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(mean)))) return;
    vec4 before = push.sample_index == 0 ? vec4(0.0) : imageLoad(mean, pixel);
    imageStore(mean, pixel, before + texelFetch(lit, pixel, 0) / float(push.samples));
}
