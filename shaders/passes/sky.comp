#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "encoding/color.glsl"
#include "interop/lighting.h"
#include "interop/work_list.h"

layout(local_size_x = WORK_LIST_THREADS) in;
layout(set = 0, binding = LIGHTING_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = LIGHTING_INSCATTERED_SLOT) uniform sampler2D inscattered_image;
layout(set = 0, binding = LIGHTING_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_image;
layout(set = 0, binding = LIGHTING_LIT_SLOT, rgba32f) uniform writeonly image2D lit_image;
layout(push_constant, scalar) uniform Push { SkyPush push; };

#define WORK_LIST_SLOT LIGHTING_WORK_SLOT
#include "frame/air_layer.glsl"
#include "frame/celestial.glsl"
#include "frame/pixel_depth.glsl"
#include "frame/pixel_work.glsl"

void light_pixel(ivec2 pixel, bool listed) {
    AirLight air = air_before(pixel);
    vec3 in_front = air.inscattered * frame.atmosphere.solar_irradiance;
    vec3 behind = celestial_radiance(pixel, in_front, push.celestial_turn);
    if ((frame.flags & FRAME_STUDIO) != 0) behind = frame.backdrop;
    if (listed && pixel_depth(pixel) <= 0.0) imageStore(lit_image, pixel, vec4(behind * air.transmittance + in_front, 1.0));
}

void main() {
    PixelBlock block = listed_block(SKY_WORK);
    ivec2 size = imageSize(lit_image);
    int row = 0;
    do light_pixel(pixel_of(block, row, size), block.listed);
    while (++row < PIXEL_WORK_ROWS);
}
