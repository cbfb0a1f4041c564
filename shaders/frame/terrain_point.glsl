// Where a surface lies in the map of the light on terrain, `terrain_light_image`.
#ifndef ALPENGLOW_FRAME_TERRAIN_POINT
#define ALPENGLOW_FRAME_TERRAIN_POINT
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

#endif
