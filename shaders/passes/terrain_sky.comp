#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "atmosphere/inscattering.glsl"
#include "frame/terrain_map.glsl"

layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = TERRAIN_SKY_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(binding = TERRAIN_SKY_ORDERS_SLOT) uniform sampler2D orders_table;
layout(binding = TERRAIN_SKY_RESULT_SLOT, rgba32f) uniform writeonly image2D result;

const int SIDE = 4;   // rays to each side of a texel
const int CELLS = 16; // of a ray

// Per unit of the sun's irradiance, from an altitude [m] over the scene's origin.
vec3 sky_radiance(float altitude, vec3 direction) {
    Atmosphere atmosphere = frame.atmosphere;
    vec3 up = frame.terrain.z;
    AirRay ray = make_air_ray(atmosphere.ground_radius, altitude, dot(direction, up), dot(up, frame.to_sun), dot(direction, frame.to_sun));
    AirSegment segment = air_segment(atmosphere, ray);
    AirLight light = compute_air_light(atmosphere, sunlight_table, orders_table, ray, segment.begin, segment.end, CELLS);
    float mu_s = air_point_at(ray, segment.end).mu_s;
    vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, 0.0, mu_s) * max(mu_s, 0.0);
    vec3 sky = sample_diffuse_irradiance(orders_table, atmosphere, 0.0, mu_s, 1.0, mu_s);
    return behind_air(light, ground_radiance(atmosphere, sun + sky) * (segment.hits_ground ? 1.0 : 0.0));
}

vec3 world_direction(vec2 level, float sine) {
    float cosine = sqrt(max(1.0 - sine * sine, 0.0));
    return (frame.terrain.x * level.x + frame.terrain.y * level.y) * cosine + frame.terrain.z * sine;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(result)))) return;
    int azimuth = at.x / TERRAIN_BANDS, band = at.x % TERRAIN_BANDS;
    float z = terrain_height((float(at.y) + 0.5) / float(TERRAIN_ALTITUDES));
    float altitude = clamp(frame.terrain.altitude + z, 0.0, frame.atmosphere.top_altitude);
    vec3 sum = vec3(0.0);
    int i = 0;
    do {
        vec2 share = (vec2(i % SIDE, i / SIDE) + 0.5) / float(SIDE);
        vec2 level = terrain_azimuth(float(azimuth) + share.x - 0.5);
        sum += sky_radiance(altitude, world_direction(level, mix(TERRAIN_BAND_EDGES[band], TERRAIN_BAND_EDGES[band + 1], share.y)));
    } while (++i < SIDE * SIDE);
    imageStore(result, at, vec4(sum / float(SIDE * SIDE), 0.0));
}
