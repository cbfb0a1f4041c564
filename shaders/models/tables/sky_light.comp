#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "frame/table_texel.glsl"
#include "models/tables/sky_light.glsl"

layout(set = 0, binding = TABLE_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = TABLE_ISOTROPIC_SLOT) uniform sampler2D isotropic_table;
layout(set = 0, binding = TABLE_RESULT_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = table_texel(SKY_LIGHT_WIDTH);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT);
    vec2 node = altitude_sun_from_uv(frame.atmosphere, uv, SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT);
    vec3 irradiance = compute_sky_light(frame.atmosphere, sunlight_table, isotropic_table, node.x, node.y);
    imageStore(table, texel, vec4(root32(irradiance), 1.0f));
}
