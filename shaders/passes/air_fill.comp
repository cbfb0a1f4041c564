#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
// The air of twice as many texels each way: interpolated where that is good enough. Where it is not - at skylines, at the edges of
// shafts - it is listed for `air_repair`.
#include "interop/air.h"
#include "interop/frame_block.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = AIR_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = AIR_INSCATTERED_SLOT, rgba32f) uniform writeonly image2D inscattered_image;
layout(set = 0, binding = AIR_TRANSMITTANCE_SLOT, rgba32f) uniform writeonly image2D transmittance_image;
layout(set = 0, binding = AIR_COARSE_INSCATTERED_SLOT) uniform sampler2D coarse_inscattered;
layout(set = 0, binding = AIR_COARSE_TRANSMITTANCE_SLOT) uniform sampler2D coarse_transmittance;
layout(push_constant, scalar) uniform Push { AirPush push; };

#define WORK_LIST_SLOT AIR_WORK_SLOT
#include "frame/air_between.glsl"
#include "frame/pixel_ray.glsl"
#include "frame/work_list.glsl"
#include "models/@AIR_MODEL@.glsl" // CMakeLists.txt: once with each file of that folder

// The radiance below which no error is seen: of the sky's mean light at the camera.
float faint_radiance() {
    AirPoint camera = AirPoint(frame.camera_altitude, 1.0, dot(frame.camera_up, frame.to_sun));
    SurfaceLight light = surface_light(camera, SurfaceDirections(1.0, camera.mu_s, 1.0, camera.mu_s, 1.0));
    return FAINT_SHARE * luminance(light.sky) / PI;
}

void fill_cell(ivec2 corner, float faint) {
    ivec2 size = imageSize(inscattered_image);
    CoarseCell cell = read_coarse_cell(corner, 2 * push.stride);
    for (int i = 0; i < 4; ++i) {
        ivec2 part = ivec2(i & 1, i >> 1), texel = 2 * corner + part;
        if (any(greaterThanEqual(texel, size))) continue;
        float error;
        AirLight air = air_between(cell, 0.5 * vec2(part), pixel_depth(texel * push.stride), faint, error);
        imageStore(inscattered_image, texel, vec4(air.inscattered, 1.0));
        imageStore(transmittance_image, texel, vec4(air.transmittance, 1.0));
        if (error > 1.0 && i > 0) list_work(uint(texel.x) | uint(texel.y) << 16);
    }
}

void main() {
    ivec2 corner = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, AIR_FILL_ROWS);
    float faint = faint_radiance();
    int row = 0;
    do fill_cell(corner + ivec2(0, row), faint);
    while (++row < AIR_FILL_ROWS);
}
