// Looking into the map of the light on terrain, `terrain_light_image`.
#ifndef ALPENGLOW_FRAME_TERRAIN_LIGHT
#define ALPENGLOW_FRAME_TERRAIN_LIGHT
#include "frame/terrain_map.glsl"

const float TERRAIN_FADE = 0.05; // share of the map's side over which it gives way at its border
const float TERRAIN_NEAR_SURFACE = 2.0, TERRAIN_BELOW_SURFACE = 4.0; // [texels] under an overhang it gives way between them

struct TerrainPoint {
    vec2 uv;
    float share; // 0 to 1, of the light that the map knows
};

vec4 terrain_light_tile(vec2 uv, int tile) {
    float border = 0.5 / float(textureSize(terrain_light_image, 0).x);
    float v = clamp(uv.y, border, 1.0 - border);
    return textureLod(terrain_light_image, vec2(uv.x, (v + float(tile)) / float(TERRAIN_LIGHT_TILES)), 0.0);
}

// `relative`: a surface's place from the camera, world axes [m].
TerrainPoint terrain_point(vec3 relative) {
    TerrainMap map = frame.terrain;
    vec3 place = vec3(dot(relative - map.origin, map.x), dot(relative - map.origin, map.y), dot(relative - map.origin, map.z));
    vec2 uv = map.size > 0 ? terrain_uv(place.xy) : vec2(0.0);
    vec2 inside = clamp(min(uv, 1.0 - uv) / TERRAIN_FADE, 0.0, 1.0);
    float below = (terrain_height(terrain_light_tile(uv, TERRAIN_LIGHT_TILES - 1).a) - place.z) / max(map.texel, TINY);
    return TerrainPoint(uv, inside.x * inside.y * (1.0 - smoothstep(TERRAIN_NEAR_SURFACE, TERRAIN_BELOW_SURFACE, below)));
}

// From all round, on a surface with this normal, world axes (Ramamoorthi and Hanrahan 2001, Eqs. 1 to 3).
vec3 terrain_irradiance(vec2 uv, vec3 normal) {
    vec3 n = vec3(dot(normal, frame.terrain.x), dot(normal, frame.terrain.y), dot(normal, frame.terrain.z));
    vec4 a = terrain_light_tile(uv, 0), b = terrain_light_tile(uv, 1), c = terrain_light_tile(uv, 2);
    vec4 d = terrain_light_tile(uv, 3), e = terrain_light_tile(uv, 4), f = terrain_light_tile(uv, 5);
    vec3 g = terrain_light_tile(uv, 6).rgb;
    vec3 sum = a.rgb + vec3(a.a, b.rg) * n.x + vec3(b.ba, c.r) * n.y + c.gba * n.z + d.rgb * (n.x * n.y) +
               vec3(d.a, e.rg) * (n.y * n.z) + vec3(e.ba, f.r) * (3.0 * n.z * n.z - 1.0) + f.gba * (n.x * n.z) +
               g * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0));
}

#endif
