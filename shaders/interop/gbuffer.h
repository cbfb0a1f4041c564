// The G-buffer: 24 bytes a pixel. Formats and their precision:
//   albedo    RGBA8 sRGB        diffuse colour, half a step of 1/255 in sRGB; alpha: occlusion, 1/510
//   normal    RGBA16 SNORM      octahedral, world axes; xy shading normal, zw surface normal: below 0.005 degrees
//   material  RGBA8 UNORM       perceptual roughness, metalness, gloss (0: Lambert alone): 1/510; alpha: a dielectric's
//                               reflectance at normal incidence over LARGEST_REFLECTANCE: 0.0004
//   emission  B10G11R11 UFLOAT  radiance relative to the sun's irradiance, 1/128 (blue 1/64) relative
//   depth     D32 SFLOAT        reversed, infinite: 6e-8 relative
#ifndef ALPENGLOW_INTEROP_GBUFFER_H
#define ALPENGLOW_INTEROP_GBUFFER_H
#include "interop/frame.h"

// Set 0
// Set 1: the material
#define MATERIAL_CONSTANTS_SLOT 0
#define MATERIAL_BASE_COLOR_SLOT 1
#define MATERIAL_METALLIC_ROUGHNESS_SLOT 2
#define MATERIAL_NORMAL_SLOT 3
#define MATERIAL_OCCLUSION_SLOT 4
#define MATERIAL_EMISSION_SLOT 5
#define MATERIAL_SPECULAR_SLOT 6
#define MATERIAL_REFLECTANCE_SLOT 7
#define MATERIAL_TEXTURES 7

// Attachments
#define GBUFFER_ALBEDO_TARGET 0
#define GBUFFER_NORMAL_TARGET 1
#define GBUFFER_MATERIAL_TARGET 2
#define GBUFFER_EMISSION_TARGET 3

// Vertex attributes
#define VERTEX_POSITION 0
#define VERTEX_NORMAL 1   // xyz
#define VERTEX_TANGENT 2  // xyz, w the bitangent's sign; 0: none, from derivatives
#define VERTEX_UV 3       // two sets
#define VERTEX_COLOR 4    // linear RGBA

#define MATERIAL_ALPHA_MASK 1
#define MATERIAL_DOUBLE_SIDED 2
#define MATERIAL_NORMAL_MAP 4
#define MATERIAL_UNLIT 8
#define MATERIAL_SPECULAR_MAPS 16 // one of the textures behind the emission's, or both

#define LARGEST_REFLECTANCE 0.2f // a dielectric's at normal incidence; an index of refraction of 2.6

SHADER_NAMESPACE_BEGIN

// Push constants of a mesh draw.
struct MeshDraw {
    mat3 world_from_mesh;
    vec3 camera_high;  // the camera in the mesh's frame, in two floats [m]
    vec3 camera_low;
    int projection;    // PROJECTION_…
};
CHECK_SIZE(MeshDraw, 64);

struct MaterialConstants {
    vec4 base_color;
    vec3 emission;
    float metallic;
    float roughness;
    float normal_scale;
    float occlusion_strength;
    float alpha_cutoff;
    int flags;         // MATERIAL_…
    int uv_sets;       // bit i: texture i uses the second set
    float specular;    // weight of a dielectric's specular part
    float reflectance; // of a dielectric at normal incidence, the mean of its colours
    vec3 reflectance_shares; // of the colours in it; their sum is 1
    mat3x2 uv_from_vertex[MATERIAL_TEXTURES];
};
CHECK_SIZE(MaterialConstants, 244);

SHADER_NAMESPACE_END
#endif
