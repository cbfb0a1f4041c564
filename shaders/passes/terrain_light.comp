#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_vote : require
#include "atmosphere/shadow_ceiling.glsl"
#include "frame/terrain_map.glsl"

// From each texel the terrain is followed outwards in each azimuth: what rises above all before it is seen, and above the last
// of it the sky.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = TERRAIN_LIGHT_SKY_SLOT) uniform sampler2D sky_image;
layout(binding = TERRAIN_LIGHT_GLOW_SLOT) uniform sampler2D glow_image;
layout(binding = TERRAIN_LIGHT_FACING_SLOT) uniform sampler2D facing_image;
layout(binding = TERRAIN_LIGHT_CEILING_SLOT) uniform sampler2D ceiling_map;
layout(binding = TERRAIN_LIGHT_RESULT_SLOT, rgba16f) uniform writeonly image2D result;

const int STEPS = 20;                     // the last is 600 texels away
const float GROWTH = 1.3, FURTHER = 0.5;  // each step is so much longer than the last [texels]

// Light of one sector by the elevation, of which s is the sine and c the cosine: the sums of radiance times 1, s, c, s c, s² and s⁴.
struct Sector {
    vec3 one, s, c, sc, ss, s4;
};

Sector empty_sector() { return Sector(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)); }

// Radiance between the sines of two elevations.
void add_light(inout Sector sector, vec3 radiance, float low, float high) {
    float s = 0.5 * (low + high), c = sqrt(max(1.0 - s * s, 0.0));
    vec3 light = radiance * max(high - low, 0.0);
    sector.one += light;
    sector.s += light * s;
    sector.c += light * c;
    sector.sc += light * (s * c);
    sector.ss += light * (s * s);
    sector.s4 += light * (s * s * s * s);
}

struct Horizon {
    float sine; // of its elevation
    float rise; // of what makes it, above the texel [m]
};

// Adds what is seen of the terrain. Faces too steep for the map show tops that
// turn away: these shine as what was seen last.
Horizon add_terrain(inout Sector sector, ivec2 at, vec2 towards) {
    vec4 last = texelFetch(glow_image, at, 0);
    Horizon horizon = Horizon(-1.0, 0.0);
    float z = last.a, steps = 1.0; // [texels]
    int i = 0;
    do {
        ivec2 apart = ivec2(round(vec2(towards.x, -towards.y) * steps)), there = at + apart;
        bool inside = all(greaterThanEqual(there, ivec2(0))) && all(lessThan(there, ivec2(frame.terrain.size)));
        vec4 glow = texelFetch(glow_image, there, 0);
        vec3 way = vec3(float(apart.x) * frame.terrain.texel, float(-apart.y) * frame.terrain.texel, glow.a - z);
        float sine = way.z * inversesqrt(dot(way, way));
        bool seen = inside && sine > horizon.sine;
        if (inside && dot(texelFetch(facing_image, there, 0).xyz, way) < 0.0) last = glow;
        add_light(sector, last.rgb, horizon.sine, seen ? sine : horizon.sine);
        if (seen) horizon = Horizon(sine, way.z);
        steps = steps * GROWTH + FURTHER;
    } while (++i < STEPS);
    return horizon;
}

// The shadow of terrain over a place, in the map's axes.
struct Shade {
    vec3 sun, over; // over: at right angles to the sun's rays, upwards
    float depth;    // how far the shadow reaches along `over` [m]
    float crest;    // and to what casts it along the rays [m]
};

Shade shade_over(ivec2 at, float z) {
    CeilingPlace in_ceiling = ceiling_surface_place(frame.ceiling, frame.light_from_world * terrain_relative(terrain_middle(at), z));
    vec2 caster = textureLod(ceiling_map, in_ceiling.uv, 0.0).rg;
    vec3 sun = terrain_axes(frame.to_sun), over = normalize(vec3(-sun.xy * sun.z, max(1.0 - sun.z * sun.z, 1e-6)));
    float depth = max(caster.x - in_ceiling.over, 0.0);
    return Shade(sun, over, depth > frame.ceiling.deepest ? 0.0 : depth, max(caster.y - in_ceiling.along, 0.0));
}

// How far air is shaded along a ray [m]: until it leaves the shadow above, or towards the sun passes what casts it.
float shaded_distance(Shade shade, vec3 direction) {
    float above = shade.depth / max(dot(direction, shade.over), 1e-4), beyond = shade.crest / max(dot(direction, shade.sun), 1e-4);
    return min(above, beyond);
}

// Radiance of the sky in an azimuth's band, above the horizon.
vec3 sky_radiance(float azimuth_and_band, float v, float shade) {
    float u = (azimuth_and_band + 0.5) / float(TERRAIN_AZIMUTHS * TERRAIN_BANDS), lower = min(floor(shade), float(TERRAIN_SHADES - 2));
    float border = 0.5 / float(TERRAIN_ALTITUDES), row = clamp(v, border, 1.0 - border) + lower;
    return mix(textureLod(sky_image, vec2(u, row / float(TERRAIN_SHADES)), 0.0).rgb,
               textureLod(sky_image, vec2(u, (row + 1.0) / float(TERRAIN_SHADES)), 0.0).rgb, shade - lower);
}

void add_sky(inout Sector sector, float horizon, int azimuth, float v, Shade shade) {
    vec2 level = terrain_azimuth(float(azimuth));
    int band = 0;
    while (band < TERRAIN_BANDS - 1 && subgroupAll(TERRAIN_BAND_EDGES[band + 1] <= horizon)) ++band;
    do {
        float high = TERRAIN_BAND_EDGES[band + 1], low = clamp(horizon, TERRAIN_BAND_EDGES[band], high), s = 0.5 * (low + high);
        float shaded = shaded_distance(shade, vec3(level * sqrt(max(1.0 - s * s, 0.0)), s));
        add_light(sector, sky_radiance(float(azimuth * TERRAIN_BANDS + band), v, shade_of_distance(shaded)), low, high);
    } while (++band < TERRAIN_BANDS);
}

// Irradiance on a surface of normal n: the sum of light[i] times 1, x, y, z, x y, y z, 3 z² - 1, x z, x² - y² and
// 35 z⁴ - 30 z² + 3. Each holds the squared norm of its harmonic and the cosine lobe's share of its degree, pi, 2/3 pi, pi/4 and
// -pi/24 (Ramamoorthi and Hanrahan 2001, Eqs. 3 and 8). Of degree 4 only this one, for a bright horizon all round.
const float DEGREE_0 = 0.25, DEGREE_1 = 0.5, DEGREE_2 = 15.0 / 16.0, ZONAL_2 = 5.0 / 64.0, SECTOR_2 = 15.0 / 64.0, ZONAL_4 = -3.0 / 2048.0;
const int COEFFICIENTS = 10;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, ivec2(frame.terrain.size)))) return;
    float z = texelFetch(glow_image, at, 0).a, depth = clamp((z - frame.terrain.bottom) / frame.terrain.range, 0.0, 1.0);
    vec3 light[COEFFICIENTS];
    for (int i = 0; i < COEFFICIENTS; ++i) light[i] = vec3(0.0);
    Shade shade = shade_over(at, z);
    float rim = 0.0;
    int azimuth = 0;
    do {
        vec2 d = terrain_azimuth(float(azimuth));
        Sector sector = empty_sector();
        Horizon horizon = add_terrain(sector, at, d);
        add_sky(sector, horizon.sine, azimuth, depth, shade);
        rim += max(horizon.rise, 0.0) / float(TERRAIN_AZIMUTHS);
        light[0] += DEGREE_0 * sector.one;
        light[1] += DEGREE_1 * d.x * sector.c;
        light[2] += DEGREE_1 * d.y * sector.c;
        light[3] += DEGREE_1 * sector.s;
        light[4] += DEGREE_2 * d.x * d.y * (sector.one - sector.ss);
        light[5] += DEGREE_2 * d.y * sector.sc;
        light[6] += ZONAL_2 * (3.0 * sector.ss - sector.one);
        light[7] += DEGREE_2 * d.x * sector.sc;
        light[8] += SECTOR_2 * (d.x * d.x - d.y * d.y) * (sector.one - sector.ss);
        light[9] += ZONAL_4 * (35.0 * sector.s4 - 30.0 * sector.ss + 3.0 * sector.one);
    } while (++azimuth < TERRAIN_AZIMUTHS);
    for (int i = 0; i < COEFFICIENTS; ++i) light[i] *= 2.0 * PI / float(TERRAIN_AZIMUTHS);
    ivec2 tile = ivec2(0, frame.terrain.size);
    imageStore(result, at, vec4(light[0], light[1].r));
    imageStore(result, at + tile, vec4(light[1].gb, light[2].rg));
    imageStore(result, at + 2 * tile, vec4(light[2].b, light[3]));
    imageStore(result, at + 3 * tile, vec4(light[4], light[5].r));
    imageStore(result, at + 4 * tile, vec4(light[5].gb, light[6].rg));
    imageStore(result, at + 5 * tile, vec4(light[6].b, light[7]));
    imageStore(result, at + 6 * tile, vec4(light[8], light[9].r));
    imageStore(result, at + 7 * tile, vec4(depth, rim, light[9].gb));
}
