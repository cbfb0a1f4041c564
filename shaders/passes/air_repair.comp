#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_vote : require
// The air of all pixels from that of one in `stride` each way. Between them it is interpolated where that is good enough, and
// where it is not - at skylines, at the edges of shafts - marched like them. Each workgroup first lists its tile's pixels that
// want it, and then shares them out: software devices run both sides of a branch, so that an `if` would march them all.
#include "interop/air.h"
#include "interop/frame_block.glsl"

layout(local_size_x = AIR_REPAIR_THREADS) in;
layout(set = 0, binding = AIR_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = AIR_SHADOW_SLOT) uniform sampler2DArray shadow_cascades;
layout(set = 0, binding = AIR_SHADOW_BOUNDS_SLOT) uniform sampler2D shadow_bounds;
layout(set = 0, binding = AIR_CEILING_SLOT) uniform sampler2D ceiling_map;
layout(set = 0, binding = AIR_INSCATTERED_SLOT, rgba32f) uniform writeonly image2D inscattered_image;
layout(set = 0, binding = AIR_TRANSMITTANCE_SLOT, rgba32f) uniform writeonly image2D transmittance_image;
layout(set = 0, binding = AIR_COARSE_INSCATTERED_SLOT) uniform sampler2D coarse_inscattered;
layout(set = 0, binding = AIR_COARSE_TRANSMITTANCE_SLOT) uniform sampler2D coarse_transmittance;
layout(push_constant, scalar) uniform Push { AirPush push; };

#include "frame/air_between.glsl"
#include "frame/pixel_ray.glsl"
#define LIGHT_OF_RAYS
#include "models/@AIR_MODEL@.glsl" // CMakeLists.txt: once with each file of that folder

shared uint listed[AIR_REPAIR_TILE * AIR_REPAIR_TILE]; // x and y in the tile, 16 bits each
shared uint list_length;

void store(ivec2 pixel, AirLight air) {
    imageStore(inscattered_image, pixel, vec4(air.inscattered, 1.0));
    imageStore(transmittance_image, pixel, vec4(air.transmittance, 1.0));
}

// The radiance below which no error is seen: of the sky's mean light at the camera.
float faint_radiance() {
    AirPoint camera = AirPoint(frame.camera_altitude, 1.0, dot(frame.camera_up, frame.to_sun));
    SurfaceLight light = surface_light(camera, SurfaceDirections(1.0, camera.mu_s, 1.0, camera.mu_s, 1.0));
    return FAINT_SHARE * luminance(light.sky) / PI;
}

void fill_cell(ivec2 corner, ivec2 tile, float faint) {
    CoarseCell cell = read_coarse_cell(corner / push.stride, push.stride);
    ivec2 size = imageSize(inscattered_image);
    for (int y = 0; y < push.stride; ++y) {
        for (int x = 0; x < push.stride; ++x) {
            ivec2 pixel = corner + ivec2(x, y);
            if (any(greaterThanEqual(pixel, size))) continue;
            float error;
            AirLight air = air_between(cell, vec2(x, y) / float(push.stride), pixel_depth(pixel), faint, error);
            store(pixel, air);
            if (error > 1.0 && x + y > 0) listed[atomicAdd(list_length, 1)] = uint(pixel.x - tile.x) | uint(pixel.y - tile.y) << 16;
        }
    }
}

void main() {
    ivec2 tile = ivec2(gl_WorkGroupID.xy) * AIR_REPAIR_TILE;
    if (gl_LocalInvocationIndex == 0) list_length = 0;
    barrier();
    float faint = faint_radiance();
    int cells = AIR_REPAIR_TILE / push.stride; // along a side
    for (int i = int(gl_LocalInvocationIndex); i < cells * cells; i += AIR_REPAIR_THREADS)
        fill_cell(tile + push.stride * ivec2(i % cells, i / cells), tile, faint);
    barrier();
    uint i = gl_LocalInvocationIndex, length = list_length;
    do {
        uint place = i < length ? listed[i] : 0;
        ivec2 pixel = tile + ivec2(place & 0xffffu, place >> 16);
        AirLight air = air_light(view_ray(pixel));
        if (i < length) store(pixel, air);
        i += AIR_REPAIR_THREADS;
    } while (subgroupAny(i < length));
}
