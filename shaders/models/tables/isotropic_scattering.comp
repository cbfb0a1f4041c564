#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "frame/table_texel.glsl"
#include "models/tables/isotropic.glsl"

layout(set = 0, binding = TABLE_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = TABLE_RESULT_SLOT, rgba32f) uniform writeonly image2D table;

void main() {
    ivec2 texel = table_texel(ISOTROPIC_SIZE);
    vec2 uv = (vec2(texel) + vec2(0.5f)) / vec2(ISOTROPIC_SIZE);
    vec2 node = altitude_sun_from_uv(frame.atmosphere, uv, ISOTROPIC_SIZE, ISOTROPIC_SIZE);
    vec3 psi = compute_isotropic(frame.atmosphere, sunlight_table, node.x, node.y);
    imageStore(table, texel, vec4(root32(psi), 1.0f));
}
