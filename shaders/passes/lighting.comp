#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "atmosphere/sunlight.glsl"
#include "encoding/octahedral.glsl"
#include "interop/gbuffer.h"
#include "interop/lighting.h"
#include "interop/work_list.h"
#include "surface/brdf.glsl"

layout(local_size_x = WORK_LIST_THREADS) in;
layout(set = 0, binding = LIGHTING_ALBEDO_SLOT) uniform sampler2D albedo_image;
layout(set = 0, binding = LIGHTING_NORMAL_SLOT) uniform sampler2D normal_image;
layout(set = 0, binding = LIGHTING_MATERIAL_SLOT) uniform sampler2D material_image;
layout(set = 0, binding = LIGHTING_EMISSION_SLOT) uniform sampler2D emission_image;
layout(set = 0, binding = LIGHTING_DEPTH_SLOT) uniform sampler2D depth_image;
layout(set = 0, binding = LIGHTING_SHADOW_SLOT) uniform sampler2DArrayShadow shadow_cascades;
layout(set = 0, binding = LIGHTING_OPEN_SLOT) uniform sampler2D open_image;
layout(set = 0, binding = LIGHTING_INSCATTERED_SLOT) uniform sampler2D inscattered_image;
layout(set = 0, binding = LIGHTING_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_image;
layout(set = 0, binding = LIGHTING_CEILING_SLOT) uniform sampler2D ceiling_map;
layout(set = 0, binding = LIGHTING_TERRAIN_SLOT) uniform sampler2D terrain_light_image;
layout(set = 0, binding = LIGHTING_LIT_SLOT, rgba32f) uniform writeonly image2D lit_image;
layout(push_constant, scalar) uniform Push { LightingPush push; };

#define WORK_LIST_SLOT LIGHTING_WORK_SLOT
#include "frame/air_layer.glsl"
#include "frame/pixel_ray.glsl"
#include "frame/pixel_work.glsl"
#include "frame/sun_shadow.glsl"
#include "frame/terrain_light.glsl"
#include "models/@AIR_MODEL@.glsl" // CMakeLists.txt: once with each file of that folder

bool has_flag(int flag) { return (frame.flags & flag) != 0; }

float cosine(vec3 a, vec3 b) { return clamp(dot(a, b), -1.0, 1.0); }

// Share of the light from all round where the sun is hidden, and with it the bright sky around it, off the map of the light on
// terrain: tuned against the path tracer.
const float SHADED_SKY = 0.85;

// Where meshes hide the sun, a mirror that faces it shows what hides it in place of the glow around it: no brighter than light from all
// round is in the mean. Cosines with the sun from which on, and from which on wholly.
const vec2 HIDDEN_GLOW = vec2(0.94, 0.99);

// What is left of the light from all round where the share `open` of it comes in and the rest is hidden by surfaces like this one
// in the same light, which reflect it on and on.
vec3 open_share(Surface surface, float open) { return vec3(open) / (vec3(1.0) - surface.diffuse * (1.0 - open)); }

// A mirror that faces the sun behind a mesh.
vec3 without_glow(vec3 mirrored, vec3 sky, vec3 middle, float hidden) {
    float sunward = smoothstep(HIDDEN_GLOW.x, HIDDEN_GLOW.y, cosine(middle, frame.to_sun));
    return mix(mirrored, min(mirrored, sky / PI), sunward * hidden);
}

// What turns away from the sun is in its own shadow, which comes on softly below the first of these cosines (tuned: there shadow maps are
// too coarse for facets). Level ground has none: the light of the sun knows the planet's horizon.
const float GRAZING = 0.02, LOWEST_SUN = 0.002;

float own_light(float cosine, float level) {
    return min(smoothstep(0.0, GRAZING, cosine) / smoothstep(0.0, GRAZING, max(level, LOWEST_SUN)), 1.0);
}

LobeTowards lobe_towards(Lobe lobe, vec3 up) { return LobeTowards(cosine(lobe.middle, up), cosine(lobe.middle, frame.to_sun), lobe.mean_length); }

// Light that leaves a surface towards the camera, for a unit of the sun's irradiance above the air, and the shadow on it.
vec3 surface_radiance(ViewRay ray, AirPoint place) {
    ivec2 pixel = ray.pixel;
    vec3 light = ray.light * ray.distance;
    vec4 albedo = texelFetch(albedo_image, pixel, 0);
    vec4 normals = texelFetch(normal_image, pixel, 0);
    vec4 material = texelFetch(material_image, pixel, 0); // roughness, metalness, gloss, reflectance
    Surface surface = make_surface(albedo.rgb, material.y, material.x, material.z, material.w * LARGEST_REFLECTANCE);
    vec3 shading = unit_from_octahedral(normals.xy), facing = unit_from_octahedral(normals.zw);
    vec3 to_camera = -ray.direction;

    // Up at the surface: the camera's up moved along the ray.
    vec3 up = normalize(frame.camera_up * (frame.atmosphere.ground_radius + frame.camera_altitude) + ray.direction * ray.distance);
    float normal_up = cosine(shading, up);
    SurfaceLight lit;
    SpecularLobes lobes = specular_lobes(surface.alpha, shading, to_camera);
    if (has_flag(FRAME_HAS_AIR)) {
        lit = surface_light(place, SurfaceDirections(normal_up, cosine(shading, frame.to_sun), lobe_towards(lobes.plain, up), lobe_towards(lobes.grazing, up)));
    } else if (has_flag(FRAME_STUDIO)) {
        lit.sun = vec3(1.0);
        lit.sky = frame.fill;
        lit.mirrored = Mirrored(frame.fill / PI, frame.fill / PI);
    } else {
        lit.sun = vec3(sun_above_horizon(frame.atmosphere, place.altitude, place.mu_s));
        lit.sky = lit.sun * max(place.mu_s, 0.0) * frame.atmosphere.ground_albedo * (0.5 - 0.5 * normal_up);
        lit.mirrored = Mirrored(lit.sky / PI, lit.sky / PI);
    }
    float visibility = 1.0;
    if (has_flag(FRAME_SHADOWS)) {
        visibility = surface_visibility(light, frame.light_from_world * facing);
        lit.mirrored.plain = without_glow(lit.mirrored.plain, lit.sky, lobes.plain.middle, 1.0 - visibility);
        lit.mirrored.grazing = without_glow(lit.mirrored.grazing, lit.sky, lobes.grazing.middle, 1.0 - visibility);
        visibility *= own_light(dot(facing, frame.to_sun), place.mu_s);
    }

    float shaded_sky = has_flag(FRAME_HAS_AIR) ? mix(SHADED_SKY, 1.0, visibility) : 1.0; // without air no sky is bright around the sun
#ifdef LIGHT_OF_TERRAIN
    TerrainPoint terrain = terrain_point(ray.direction * ray.distance);
    mix_terrain_light(lit, terrain, shading, lobes);
    shaded_sky = mix(shaded_sky, 1.0, terrain.share);
#endif
    float n_v = clamp(dot(shading, to_camera), 0.0, 1.0);
    vec3 radiance = reflect_light(surface, shading, to_camera, frame.to_sun) * lit.sun * visibility +
                    reflect_ambient(surface, n_v, lit.sky, lit.mirrored) * open_share(surface, albedo.a * texelFetch(open_image, pixel, 0).r) * shaded_sky;
    return radiance * frame.atmosphere.solar_irradiance + texelFetch(emission_image, pixel, 0).rgb;
}

vec3 cascade_color(vec2 light) {
    const vec3 COLORS[4] = vec3[](vec3(0.9, 0.25, 0.2), vec3(0.95, 0.75, 0.2), vec3(0.3, 0.75, 0.35), vec3(0.25, 0.45, 0.9));
    CascadePlace place = choose_cascade(light, SURFACE_MARGIN, 0.0);
    return place.last_inside < 0.0 ? vec3(0.5) : COLORS[int(place.layer)];
}

void light_pixel(ivec2 pixel, bool listed) {
    ViewRay ray = view_ray(pixel);
    AirLight air = air_before(pixel);
    vec3 radiance = surface_radiance(ray, place_at(frame.atmosphere, ray.air, ray.distance)) * air.transmittance +
                    air.inscattered * frame.atmosphere.solar_irradiance;
    if (push.show == LIGHTING_SHOW_CASCADES)
        radiance = dot(radiance, vec3(0.3, 0.6, 0.1)) * 2.0 * cascade_color(ray.light.xy * ray.distance);
    if (listed && ray.distance >= 0.0) imageStore(lit_image, pixel, vec4(radiance, 1.0));
}

void main() {
    PixelBlock block = listed_block(SURFACE_WORK);
    ivec2 size = imageSize(lit_image);
    int row = 0;
    do light_pixel(pixel_of(block, row, size), block.listed);
    while (++row < PIXEL_WORK_ROWS);
}
