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

// A vector from world axes to the map's.
vec3 terrain_axes(vec3 v) { return vec3(dot(v, frame.terrain.x), dot(v, frame.terrain.y), dot(v, frame.terrain.z)); }

// A place over the map.
struct TerrainPlace {
    vec2 uv;
    float inside; // 0 to 1: away from the map's border
    float above;  // the ground that the map knows [m]
    float rim;    // mean rise of the horizon above that ground [m]
};

// `relative`: from the camera, world axes [m].
TerrainPlace terrain_place(vec3 relative) {
    vec3 place = terrain_axes(relative - frame.terrain.origin);
    vec2 uv = frame.terrain.size > 0 ? terrain_uv(place.xy) : vec2(0.0);
    vec2 inside = clamp(min(uv, 1.0 - uv) / TERRAIN_FADE, 0.0, 1.0);
    vec2 ground = terrain_light_tile(uv, TERRAIN_LIGHT_TILES - 1).xy;
    return TerrainPlace(uv, inside.x * inside.y, place.z - terrain_height(ground.x), ground.y);
}

// Of a surface.
TerrainPoint terrain_point(vec3 relative) {
    TerrainPlace place = terrain_place(relative);
    float below = -place.above / max(frame.terrain.texel, TINY);
    return TerrainPoint(place.uv, place.inside * (1.0 - smoothstep(TERRAIN_NEAR_SURFACE, TERRAIN_BELOW_SURFACE, below)));
}

// From all round, on a surface with this normal, world axes (Ramamoorthi and Hanrahan 2001, Eqs. 1 to 3).
vec3 terrain_irradiance(vec2 uv, vec3 normal) {
    vec3 n = terrain_axes(normal);
    vec4 a = terrain_light_tile(uv, 0), b = terrain_light_tile(uv, 1), c = terrain_light_tile(uv, 2);
    vec4 d = terrain_light_tile(uv, 3), e = terrain_light_tile(uv, 4), f = terrain_light_tile(uv, 5);
    vec3 g = terrain_light_tile(uv, 6).rgb;
    vec3 sum = a.rgb + vec3(a.a, b.rg) * n.x + vec3(b.ba, c.r) * n.y + c.gba * n.z + d.rgb * (n.x * n.y) +
               vec3(d.a, e.rg) * (n.y * n.z) + vec3(e.ba, f.r) * (3.0 * n.z * n.z - 1.0) + f.gba * (n.x * n.z) +
               g * (n.x * n.x - n.y * n.y);
    return max(sum, vec3(0.0));
}

// Light of degrees 0 and 1 that the map knows in the air over its ground.
struct TerrainAir {
    float share; // 0 to 1, of the light there
    vec3 mean;   // over all directions [1/sr]
    vec3 first;  // of degree 1 in one direction, relative to the mean
};

const float TERRAIN_TOP = 3.0; // [rims] above the ground where no horizon counts any more: the light rises to it from that of the ground

// In light that goes on in `direction`, world axes.
TerrainAir terrain_air(vec3 relative, vec3 direction) {
    TerrainPlace place = terrain_place(relative);
    vec4 a = terrain_light_tile(place.uv, 0), b = terrain_light_tile(place.uv, 1), c = terrain_light_tile(place.uv, 2);
    vec3 d = terrain_axes(direction), mean = max(a.rgb / PI, vec3(1e-20));
    vec3 first = (vec3(a.a, b.rg) * d.x + vec3(b.ba, c.r) * d.y + c.gba * d.z) * (1.5 / PI);
    float share = place.inside * (1.0 - smoothstep(0.0, max(TERRAIN_TOP * place.rim, 1.0), place.above));
    return TerrainAir(share, mean, first / mean);
}

#endif
