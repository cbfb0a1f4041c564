// Set 1 of mesh draws: the material's constants and textures.
#ifndef ALPENGLOW_FRAME_MESH_MATERIAL
#define ALPENGLOW_FRAME_MESH_MATERIAL
#include "interop/gbuffer.h"

layout(set = 1, binding = MATERIAL_CONSTANTS_SLOT, scalar) uniform MaterialBlock { MaterialConstants material; };
layout(set = 1, binding = MATERIAL_BASE_COLOR_SLOT) uniform sampler2D base_color_texture;
layout(set = 1, binding = MATERIAL_METALLIC_ROUGHNESS_SLOT) uniform sampler2D metallic_roughness_texture;
layout(set = 1, binding = MATERIAL_NORMAL_SLOT) uniform sampler2D normal_texture;
layout(set = 1, binding = MATERIAL_OCCLUSION_SLOT) uniform sampler2D occlusion_texture;
layout(set = 1, binding = MATERIAL_EMISSION_SLOT) uniform sampler2D emission_texture;
layout(set = 1, binding = MATERIAL_SPECULAR_SLOT) uniform sampler2D specular_texture;
layout(set = 1, binding = MATERIAL_REFLECTANCE_SLOT) uniform sampler2D reflectance_texture;

// Where the vertex's two UV sets lie in texture `slot`.
vec2 uv_of(int slot, vec4 uv) {
    int i = slot - MATERIAL_BASE_COLOR_SLOT;
    vec2 own = ((material.uv_sets >> i) & 1) != 0 ? uv.zw : uv.xy;
    return material.uv_from_vertex[i] * vec3(own, 1.0);
}

// `bias`: of the mipmap's level.
vec4 base_color_at(vec4 uv, vec4 vertex_color, float bias) {
    return material.base_color * vertex_color * texture(base_color_texture, uv_of(MATERIAL_BASE_COLOR_SLOT, uv), bias);
}

bool cut_out(float alpha) { return (material.flags & MATERIAL_ALPHA_MASK) != 0 && alpha < material.alpha_cutoff; }

#endif
