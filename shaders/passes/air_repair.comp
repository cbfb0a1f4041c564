#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_vote : require
// The air of those texels that `air_fill` listed, marched.
#include "interop/air.h"
#include "interop/frame_block.glsl"
#include "interop/work_list.h"

layout(local_size_x = WORK_LIST_THREADS) in;
layout(set = 0, binding = AIR_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = AIR_SHADOW_SLOT) uniform sampler2DArray shadow_cascades;
layout(set = 0, binding = AIR_SHADOW_BOUNDS_SLOT) uniform sampler2D shadow_bounds;
layout(set = 0, binding = AIR_CEILING_SLOT) uniform sampler2D ceiling_map;
layout(set = 0, binding = AIR_TERRAIN_SLOT) uniform sampler2D terrain_air_image;
layout(set = 0, binding = AIR_INSCATTERED_SLOT, rgba32f) uniform writeonly image2D inscattered_image;
layout(set = 0, binding = AIR_TRANSMITTANCE_SLOT, rgba32f) uniform writeonly image2D transmittance_image;
layout(push_constant, scalar) uniform Push { AirPush push; };

#define WORK_LIST_SLOT AIR_WORK_SLOT
#include "frame/pixel_ray.glsl"
#include "frame/work_list.glsl"
#define LIGHT_OF_RAYS
#include "models/@AIR_MODEL@.glsl" // CMakeLists.txt: once with each file of that folder

void main() {
    uint entry;
    bool listed = listed_work(uint(push.kind), entry);
    ivec2 texel = ivec2(entry & 0xffffu, entry >> 16);
    AirLight air = air_light(view_ray(texel * push.stride));
    if (!listed) return;
    imageStore(inscattered_image, texel, vec4(air.inscattered, 1.0));
    imageStore(transmittance_image, texel, vec4(air.transmittance, 1.0));
}
