#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/terrain_light.h"

// The light on terrain as the air over it sees it: the mean of many texels, since rays look in few places.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = TERRAIN_AIR_LIGHT_SLOT) uniform sampler2D light_image;
layout(binding = TERRAIN_AIR_RESULT_SLOT, rgba16f) uniform writeonly image2D result;

// Of a tile of the light, over the texel `at` of a tile of the result, which is `side` texels wide.
vec4 mean_light(ivec2 at, int side, int tile) {
    vec4 sum = vec4(0.0);
    int i = 0;
    do {
        vec2 uv = (vec2(at) + (vec2(i % TERRAIN_AIR_TEXELS, i / TERRAIN_AIR_TEXELS) + 0.5) / float(TERRAIN_AIR_TEXELS)) / float(side);
        sum += textureLod(light_image, vec2(uv.x, (uv.y + float(tile)) / float(TERRAIN_LIGHT_TILES)), 0.0);
    } while (++i < TERRAIN_AIR_TEXELS * TERRAIN_AIR_TEXELS);
    return sum / float(TERRAIN_AIR_TEXELS * TERRAIN_AIR_TEXELS);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    int side = imageSize(result).x;
    if (any(greaterThanEqual(at, ivec2(side)))) return;
    for (int tile = 0; tile < TERRAIN_AIR_TILES - 1; ++tile)
        imageStore(result, at + ivec2(0, tile * side), mean_light(at, side, tile));
    imageStore(result, at + ivec2(0, (TERRAIN_AIR_TILES - 1) * side), mean_light(at, side, TERRAIN_LIGHT_TILES - 1));
}
