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
const int CELLS = 4;  // of a ray between two ends of the shade, twice as many behind the last

// Light along a ray, and what of it is lost where terrain shades the air.
struct SkyLight {
    AirLight all, lost;
};

void add_stretch(inout SkyLight light, RayPhases phases, AirRay ray, float begin, float end, int n) {
    Atmosphere atmosphere = frame.atmosphere;
    MarchCells cells = make_march_cells(atmosphere, ray, begin, end);
    float from = begin;
    int i = 0;
    do {
        MarchCell cell = march_cell_from(cells, from, i, n);
        from = cell.end;
        AirPoint point = air_point_at(ray, cell.middle);
        Medium medium = medium_at(atmosphere, point.altitude);
        vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, point.altitude, point.mu_s);
        DiffuseLight diffuse = sample_diffuse_light(orders_table, atmosphere, point, ray.nu);
        diffuse.known = 1.0;
        vec3 source = inscattering_source(medium, phases, sun, diffuse);
        vec3 shaded = diffuse_source(medium, shaded_light(atmosphere, phases, diffuse, 0.0)), extinction = diffuse_extinction(atmosphere, medium);
        add_cell(light.all, source, extinction, cell.end - cell.begin);
        add_cell(light.lost, source - shaded, extinction, cell.end - cell.begin);
    } while (++i < n);
}

// Adds radiance per unit of the sun's irradiance from an altitude [m] over the scene's origin, for each of the shades.
void add_radiance(inout vec3 radiance[TERRAIN_SHADES], float altitude, vec3 direction) {
    Atmosphere atmosphere = frame.atmosphere;
    vec3 up = frame.terrain.z;
    AirRay ray = make_air_ray(atmosphere.ground_radius, altitude, dot(direction, up), dot(up, frame.to_sun), dot(direction, frame.to_sun));
    AirSegment segment = air_segment(atmosphere, ray);
    RayPhases phases = phases_of(atmosphere, ray.nu);
    SkyLight light = SkyLight(no_air_light(), no_air_light());
    vec3 lost[TERRAIN_SHADES];
    int i = 0;
    do {
        lost[i] = light.lost.inscattered;
        bool last = i == TERRAIN_SHADES - 1;
        float begin = min(terrain_shade(float(i)), segment.end), end = last ? segment.end : min(terrain_shade(float(i + 1)), segment.end);
        add_stretch(light, phases, ray, begin, end, last ? 2 * CELLS : CELLS);
    } while (++i < TERRAIN_SHADES);
    float mu_s = air_point_at(ray, segment.end).mu_s;
    vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, 0.0, mu_s) * max(mu_s, 0.0);
    vec3 sky = sample_diffuse_irradiance(orders_table, atmosphere, 0.0, mu_s, 1.0, mu_s);
    vec3 all = behind_air(light.all, ground_radiance(atmosphere, sun + sky) * (segment.hits_ground ? 1.0 : 0.0));
    for (int j = 0; j < TERRAIN_SHADES; ++j) radiance[j] += all - lost[j];
}

vec3 world_direction(vec2 level, float sine) {
    float cosine = sqrt(max(1.0 - sine * sine, 0.0));
    return (frame.terrain.x * level.x + frame.terrain.y * level.y) * cosine + frame.terrain.z * sine;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(TERRAIN_AZIMUTHS * TERRAIN_BANDS, TERRAIN_ALTITUDES)))) return;
    int azimuth = at.x / TERRAIN_BANDS, band = at.x % TERRAIN_BANDS;
    float z = terrain_height((float(at.y) + 0.5) / float(TERRAIN_ALTITUDES));
    float altitude = clamp(frame.terrain.altitude + z, 0.0, frame.atmosphere.top_altitude);
    vec3 sum[TERRAIN_SHADES];
    for (int j = 0; j < TERRAIN_SHADES; ++j) sum[j] = vec3(0.0);
    int i = 0;
    do {
        vec2 share = (vec2(i % SIDE, i / SIDE) + 0.5) / float(SIDE);
        vec2 level = terrain_azimuth(float(azimuth) + share.x - 0.5);
        add_radiance(sum, altitude, world_direction(level, mix(TERRAIN_BAND_EDGES[band], TERRAIN_BAND_EDGES[band + 1], share.y)));
    } while (++i < SIDE * SIDE);
    for (int j = 0; j < TERRAIN_SHADES; ++j)
        imageStore(result, at + ivec2(0, j * TERRAIN_ALTITUDES), vec4(sum[j] / float(SIDE * SIDE), 0.0));
}
