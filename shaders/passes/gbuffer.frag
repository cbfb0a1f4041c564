#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "atmosphere/math.glsl"
#include "encoding/octahedral.glsl"
#include "frame/mesh_material.glsl"

layout(location = 0) in vec3 relative;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec4 uv;
layout(location = 4) in vec4 color;

layout(location = GBUFFER_ALBEDO_TARGET) out vec4 out_albedo;
layout(location = GBUFFER_NORMAL_TARGET) out vec4 out_normal;
layout(location = GBUFFER_MATERIAL_TARGET) out vec4 out_material;
layout(location = GBUFFER_EMISSION_TARGET) out vec3 out_emission;

vec4 texel(sampler2D image, int slot) { return texture(image, uv_of(slot, uv), frame.texture_bias); }

// Tangent and bitangent from how position and texture coordinates change across the screen
// (Schueler 2013, "Followup: Normal Mapping Without Precomputed Tangents"). The bitangent points to decreasing v, up in the
// picture, as glTF wants it; the sign of the screen's handedness is taken out.
mat3 frame_from_derivatives(vec3 n, vec2 coordinates) {
    vec3 dx = dFdx(relative), dy = dFdy(relative);
    vec2 du = dFdx(coordinates), dv = dFdy(coordinates);
    float handed = dot(cross(dx, dy), n) >= 0.0 ? 1.0 : -1.0;
    vec3 across_y = cross(dy, n), across_x = cross(n, dx);
    vec3 t = (across_y * du.x + across_x * dv.x) * handed;
    vec3 b = (across_y * du.y + across_x * dv.y) * -handed;
    float scale = inversesqrt(max(max(dot(t, t), dot(b, b)), 1e-30));
    return mat3(t * scale, b * scale, n);
}

mat3 frame_from_tangent(vec3 n) {
    vec3 t = normalize(tangent.xyz - n * dot(n, tangent.xyz));
    return mat3(t, cross(n, t) * sign(tangent.w), n);
}

vec3 mapped_normal(vec3 n) {
    vec2 coordinates = uv_of(MATERIAL_NORMAL_SLOT, uv);
    vec3 bump = texel(normal_texture, MATERIAL_NORMAL_SLOT).xyz * 2.0 - 1.0;
    bump.xy *= material.normal_scale;
    mat3 world_from_bump = abs(tangent.w) > 0.5 ? frame_from_tangent(n) : frame_from_derivatives(n, coordinates);
    return normalize(world_from_bump * bump);
}

// The nearest values that B10G11R11 holds, with 6, 6 and 5 bits behind the first one: devices cut off what is beyond, which makes
// blue 1.6 % too dark on the average.
vec3 rounded_emission(vec3 emission) {
    const uvec3 step = uvec3(1u << 17, 1u << 17, 1u << 18);
    return uintBitsToFloat((floatBitsToUint(max(emission, vec3(0.0))) + step / 2u) & ~(step - 1u));
}

// A dielectric's specular weight and reflectance.
vec2 dielectric() {
    vec2 plain = vec2(material.specular, material.reflectance);
    if ((material.flags & MATERIAL_SPECULAR_MAPS) == 0) return plain;
    float weight = texel(specular_texture, MATERIAL_SPECULAR_SLOT).a;
    vec3 colors = texel(reflectance_texture, MATERIAL_REFLECTANCE_SLOT).rgb;
    return plain * vec2(weight, dot(material.reflectance_shares, colors));
}

void main() {
    vec4 base = base_color_at(uv, color, frame.texture_bias);
    if (cut_out(base.a)) discard;
    // World axes seen from the front; the back of a double-sided surface turns its normal round.
    vec3 facing = normalize(normal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 shading = (material.flags & MATERIAL_NORMAL_MAP) != 0 ? mapped_normal(facing) : facing;
    vec2 metal_rough = texel(metallic_roughness_texture, MATERIAL_METALLIC_ROUGHNESS_SLOT).bg;
    float occlusion = mix(1.0, texel(occlusion_texture, MATERIAL_OCCLUSION_SLOT).r, material.occlusion_strength);

    bool unlit = (material.flags & MATERIAL_UNLIT) != 0;
    float metalness = metal_rough.x * material.metallic;
    vec2 specular = dielectric();
    float gloss = unlit ? 0.0 : mix(specular.x, 1.0, metalness);
    out_albedo = vec4(unlit ? vec3(0.0) : base.rgb, occlusion);
    out_normal = vec4(octahedral_from_unit(shading), octahedral_from_unit(facing));
    out_material = vec4(metal_rough.y * material.roughness, metalness, gloss, specular.y / LARGEST_REFLECTANCE);
    // An unlit surface shows its colour as a Lambert surface that faces an unshaded sun of unit irradiance would.
    out_emission = rounded_emission(unlit ? base.rgb / PI : material.emission * texel(emission_texture, MATERIAL_EMISSION_SLOT).rgb);
}
