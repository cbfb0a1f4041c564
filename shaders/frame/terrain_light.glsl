// Looking into the map of the light on terrain, `terrain_light_image`.
#ifndef ALPENGLOW_FRAME_TERRAIN_LIGHT
#define ALPENGLOW_FRAME_TERRAIN_LIGHT
#include "atmosphere/light_moments.glsl"
#include "frame/air_model.glsl"
#include "frame/terrain_point.glsl"

// The irradiance of degrees 0, 1, 2 and 4 on a surface that faces along n, in the map's axes (Ramamoorthi and Hanrahan 2001, Eqs. 1 to 3).
struct TerrainDegrees {
    vec3 none, first, second, fourth;
};

TerrainDegrees terrain_degrees(vec4 tiles[TERRAIN_LIGHT_TILES], vec3 n) {
    vec4 a = tiles[0], b = tiles[1], c = tiles[2], d = tiles[3], e = tiles[4], f = tiles[5], g = tiles[6];
    float z2 = n.z * n.z;
    TerrainDegrees by;
    by.none = a.rgb;
    by.first = vec3(a.a, b.rg) * n.x + vec3(b.ba, c.r) * n.y + c.gba * n.z;
    by.second = d.rgb * (n.x * n.y) + vec3(d.a, e.rg) * (n.y * n.z) + vec3(e.ba, f.r) * (3.0 * z2 - 1.0) + f.gba * (n.x * n.z) +
                g.rgb * (n.x * n.x - n.y * n.y);
    by.fourth = vec3(g.a, tiles[7].ba) * (z2 * (35.0 * z2 - 30.0) + 3.0);
    return by;
}

// Lobes as narrow as these, by the lengths of their means, see more than the map knows.
const vec2 TERRAIN_NARROW_LOBES = vec2(0.9, 0.96);

// Mean radiance in a lobe [1/sr]: irradiance without the cosine lobe's pi, 2/3 pi, pi/4 and -pi/24. In a narrow one it is `other`.
vec3 terrain_mirrored(vec4 tiles[TERRAIN_LIGHT_TILES], Lobe lobe, vec3 other) {
    TerrainDegrees by = terrain_degrees(tiles, terrain_axes(lobe.middle));
    vec4 kept = lobe_shares(lobe.mean_length) * vec4(1.5, 4.0, 0.0, -24.0);
    vec3 known = max(by.none + kept.x * by.first + kept.y * by.second + kept.w * by.fourth, vec3(0.0)) / PI;
    return mix(known, other, smoothstep(TERRAIN_NARROW_LOBES.x, TERRAIN_NARROW_LOBES.y, lobe.mean_length));
}

// Puts the map's light from all round on a surface with this normal in place of other light; directions in world axes.
void mix_terrain_light(inout SurfaceLight lit, TerrainPoint point, vec3 normal, SpecularLobes lobes) {
    vec4 tiles[TERRAIN_LIGHT_TILES];
    for (int i = 0; i < TERRAIN_LIGHT_TILES; ++i) tiles[i] = terrain_light_tile(point.uv, i);
    TerrainDegrees by = terrain_degrees(tiles, terrain_axes(normal));
    vec3 sky = max(by.none + by.first + by.second + by.fourth, vec3(0.0)), share = sky / max(lit.sky, vec3(1e-20));
    lit.sky = mix(lit.sky, sky, point.share);
    lit.mirrored.plain = mix(lit.mirrored.plain, terrain_mirrored(tiles, lobes.plain, share * lit.mirrored.plain), point.share);
    lit.mirrored.grazing = mix(lit.mirrored.grazing, terrain_mirrored(tiles, lobes.grazing, share * lit.mirrored.grazing), point.share);
}

#endif
