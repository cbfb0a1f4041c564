#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/multiple_scattering.glsl"
#include "atmosphere/shadow_ceiling.glsl"
#include "encoding/octahedral.glsl"
#include "frame/terrain_map.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = TERRAIN_GLOW_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(binding = TERRAIN_GLOW_ORDERS_SLOT) uniform sampler2D orders_table;
layout(binding = TERRAIN_GLOW_ALBEDO_SLOT) uniform sampler2D albedo_image;
layout(binding = TERRAIN_GLOW_NORMAL_SLOT) uniform sampler2D normal_image;
layout(binding = TERRAIN_GLOW_DEPTH_SLOT) uniform sampler2D depth_image;
layout(binding = TERRAIN_GLOW_CEILING_SLOT) uniform sampler2D ceiling_map;
layout(binding = TERRAIN_GLOW_RESULT_SLOT, rgba32f) uniform writeonly image2D result;
layout(binding = TERRAIN_GLOW_FACING_SLOT, rgba16f) uniform writeonly image2D facing;

struct GroundSeen {
    vec3 albedo;
    vec3 normal; // world
    float z;     // [m]
};

// The scene; where it has a hole the planet's ground.
GroundSeen ground_from_above(ivec2 at, vec2 place) {
    float depth = texelFetch(depth_image, at, 0).r;
    bool scene = depth > 0.0;
    float sea = -frame.terrain.altitude - sphere_fall(place);
    return GroundSeen(scene ? texelFetch(albedo_image, at, 0).rgb : frame.atmosphere.ground_albedo,
                      scene ? unit_from_octahedral(texelFetch(normal_image, at, 0).xy) : frame.terrain.z,
                      scene ? terrain_height(depth) : sea);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(frame.terrain.size)))) return;
    vec2 place = terrain_middle(at);
    GroundSeen ground = ground_from_above(at, place);
    vec3 up = frame.terrain.z;
    float altitude = max(frame.terrain.altitude + ground.z + sphere_fall(place), 0.0), mu_s = dot(up, frame.to_sun);
    CeilingPlace in_ceiling = ceiling_surface_place(frame.ceiling, frame.light_from_world * terrain_relative(place, ground.z));
    float towards_sun = dot(ground.normal, frame.to_sun);
    vec3 sun = sample_sun_transmittance(sunlight_table, frame.atmosphere, altitude, mu_s) *
               (max(towards_sun, 0.0) * ceiling_visibility(ceiling_map, frame.ceiling, in_ceiling));
    vec3 sky = sample_diffuse_irradiance(orders_table, frame.atmosphere, altitude, mu_s, dot(ground.normal, up), towards_sun);
    imageStore(facing, at, vec4(dot(ground.normal, frame.terrain.x), dot(ground.normal, frame.terrain.y), dot(ground.normal, up), 0.0));
    imageStore(result, at, vec4(ground.albedo / PI * (sun + sky), ground.z));
}
