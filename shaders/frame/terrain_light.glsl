// Looking into the map of the light on terrain, `terrain_light_image`.
#ifndef ALPENGLOW_FRAME_TERRAIN_LIGHT
#define ALPENGLOW_FRAME_TERRAIN_LIGHT
#include "frame/terrain_map.glsl"

const float TERRAIN_NEAR_SURFACE = 2.0, TERRAIN_BELOW_SURFACE = 4.0; // [texels] under an overhang it gives way between them

struct TerrainPoint {
    vec2 uv;
    float share; // 0 to 1, of the light that the map knows
};

vec4 terrain_light_tile(vec2 uv, int tile) { return terrain_tile(terrain_light_image, uv, tile, TERRAIN_LIGHT_TILES); }

// `relative`: a surface's place from the camera, world axes [m].
TerrainPoint terrain_point(vec3 relative) {
    vec3 place = terrain_axes(relative - frame.terrain.origin);
    vec2 uv = terrain_uv(place.xy);
    float below = (terrain_height(terrain_light_tile(uv, TERRAIN_LIGHT_TILES - 1).x) - place.z) / max(frame.terrain.texel, TINY);
    return TerrainPoint(uv, terrain_inside(uv) * (1.0 - smoothstep(TERRAIN_NEAR_SURFACE, TERRAIN_BELOW_SURFACE, below)));
}

// From all round, on a surface with this normal, world axes (Ramamoorthi and Hanrahan 2001, Eqs. 1 to 3).
vec3 terrain_irradiance(vec2 uv, vec3 normal) {
    vec3 n = terrain_axes(normal);
    vec4 a = terrain_light_tile(uv, 0), b = terrain_light_tile(uv, 1), c = terrain_light_tile(uv, 2);
    vec4 d = terrain_light_tile(uv, 3), e = terrain_light_tile(uv, 4), f = terrain_light_tile(uv, 5);
    vec4 g = terrain_light_tile(uv, 6);
    vec2 h = terrain_light_tile(uv, 7).ba;
    float z2 = n.z * n.z;
    vec3 sum = a.rgb + vec3(a.a, b.rg) * n.x + vec3(b.ba, c.r) * n.y + c.gba * n.z + d.rgb * (n.x * n.y) +
               vec3(d.a, e.rg) * (n.y * n.z) + vec3(e.ba, f.r) * (3.0 * z2 - 1.0) + f.gba * (n.x * n.z) +
               g.rgb * (n.x * n.x - n.y * n.y) + vec3(g.a, h) * (z2 * (35.0 * z2 - 30.0) + 3.0);
    return max(sum, vec3(0.0));
}

#endif
