#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The air of twice as many texels each way: interpolated where that is good enough. Where it is not - at skylines, at the edges of
// shafts - it is listed for `air_repair`.
#include "interop/air.h"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = AIR_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = AIR_INSCATTERED_SLOT, rgba32f) uniform writeonly image2D inscattered_image;
layout(set = 0, binding = AIR_TRANSMITTANCE_SLOT, rgba32f) uniform writeonly image2D transmittance_image;
layout(set = 0, binding = AIR_COARSE_INSCATTERED_SLOT) uniform sampler2D coarse_inscattered;
layout(set = 0, binding = AIR_COARSE_TRANSMITTANCE_SLOT) uniform sampler2D coarse_transmittance;
layout(set = 0, binding = AIR_MEAN_SLOT) uniform sampler2D mean_image;
layout(push_constant, scalar) uniform Push { AirPush push; };

#define WORK_LIST_SLOT AIR_WORK_SLOT
#include "frame/air_between.glsl"
#include "frame/work_list.glsl"

void fill_cell(ivec2 corner, float mean) {
    ivec2 size = imageSize(inscattered_image);
    CoarseCell cell = read_coarse_cell(corner, 2 * push.stride);
    for (int i = 0; i < 4; ++i) {
        ivec2 part = ivec2(i & 1, i >> 1), texel = 2 * corner + part;
        if (any(greaterThanEqual(texel, size))) continue;
        float error;
        float depth = pixel_depth(texel * push.stride);
        AirLight air = air_between(cell, 0.5 * vec2(part), depth, mean, error);
        imageStore(inscattered_image, texel, vec4(air.inscattered, 1.0));
        imageStore(transmittance_image, texel, vec4(air.transmittance, 1.0));
        if (error > 1.0 && i > 0) list_work(depth > 0.0 ? SURFACE_WORK : SKY_WORK, uint(texel.x) | uint(texel.y) << 16);
    }
}

void main() {
    ivec2 corner = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, AIR_FILL_ROWS);
    float mean = texelFetch(mean_image, ivec2(0), 0).r;
    int row = 0;
    do fill_cell(corner + ivec2(0, row), mean);
    while (++row < AIR_FILL_ROWS);
}
