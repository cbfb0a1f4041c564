#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "models/tables/sky_view.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(set = 0, binding = TABLE_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = TABLE_ISOTROPIC_SLOT) uniform sampler2D isotropic_table;
layout(set = 0, binding = TABLE_RESULT_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(table)))) return;
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(SKY_VIEW_WIDTH, SKY_VIEW_HEIGHT);
    float altitude = clamp(frame.camera_altitude, 0.0f, frame.atmosphere.top_altitude);
    SkyDirection direction = sky_direction_from_uv(frame.atmosphere, altitude, uv);
    float mu_s = dot(frame.camera_up, frame.to_sun);
    vec3 radiance = compute_sky_view(frame.atmosphere, sunlight_table, isotropic_table, altitude, mu_s, direction);
    imageStore(table, texel, vec4(radiance, 1.0f));
}
