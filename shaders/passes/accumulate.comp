#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/tone_curves.glsl"
#include "interop/display.h"

// The running means of the supersamples: of their radiance, and of what is seen of it. A bright sky behind a dark edge is
// many times what the screen shows, so that the mean of radiance leaves stairs where the mean of what is seen does not.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = ACCUMULATE_LIT_SLOT) uniform sampler2D lit;
layout(binding = ACCUMULATE_MEAN_SLOT, rgba32f) uniform image2D mean;
layout(binding = ACCUMULATE_TONED_SLOT, rgba32f) uniform image2D toned;
layout(binding = ACCUMULATE_EXPOSURE_SLOT) uniform sampler2D exposure;
layout(constant_id = 0) const int curve = CURVE_FILMIC;
layout(push_constant, scalar) uniform Push { AccumulatePush push; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(mean)))) return;
    vec4 radiance = texelFetch(lit, pixel, 0);
    vec4 seen = vec4(tone_curve(curve, radiance.rgb * texelFetch(exposure, ivec2(0), 0).r), 1.0);
    bool first = push.sample_index == 0;
    imageStore(mean, pixel, (first ? vec4(0.0) : imageLoad(mean, pixel)) + radiance / float(push.samples));
    imageStore(toned, pixel, (first ? vec4(0.0) : imageLoad(toned, pixel)) + seen / float(push.samples));
}
