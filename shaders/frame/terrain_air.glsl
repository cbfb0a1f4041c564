// Light from all round in the air over terrain, by its image `terrain_air_image`.
#ifndef ALPENGLOW_FRAME_TERRAIN_AIR
#define ALPENGLOW_FRAME_TERRAIN_AIR
#include "frame/terrain_map.glsl"

// Light of degrees 0 and 1.
struct TerrainAir {
    float share; // 0 to 1, of the light that the map knows there
    float known; // 0 to 1, of the light that knows what meshes hide: where the map is wide, above its terrain and around it too
    vec3 mean;   // over all directions [1/sr]
    vec3 first;  // of degree 1 in one direction, relative to the mean
};

const float TERRAIN_TOP = 3.0; // [rims] above the ground no horizon counts any more; up to there the light goes over to that without terrain

// Side of maps [m]: a ray looks into the map at three places for eight cells, which pass small ones by.
const float TERRAIN_SMALL = 3e4, TERRAIN_WIDE = 6e4;

vec4 terrain_air_tile(vec2 uv, int tile) { return terrain_tile(terrain_air_image, uv, tile, TERRAIN_AIR_TILES); }

// At a place `relative` to the camera, world axes [m]; in light that goes on in `direction`.
TerrainAir terrain_air(vec3 relative, vec3 direction) {
    vec3 place = terrain_axes(relative - frame.terrain.origin), d = terrain_axes(direction);
    vec2 uv = terrain_uv(place.xy);
    vec4 a = terrain_air_tile(uv, 0), b = terrain_air_tile(uv, 1), c = terrain_air_tile(uv, 2);
    vec2 ground = terrain_air_tile(uv, TERRAIN_AIR_TILES - 1).xy; // height as depth has it, and rim [m]
    float above = place.z - terrain_height(ground.x);
    float wide = smoothstep(TERRAIN_SMALL, TERRAIN_WIDE, frame.terrain.texel * float(frame.terrain.size));
    float share = wide * terrain_inside(uv) * (1.0 - smoothstep(0.0, max(TERRAIN_TOP * ground.y, 1.0), above));
    vec3 mean = max(a.rgb / PI, vec3(1e-20));
    vec3 first = (vec3(a.a, b.rg) * d.x + vec3(b.ba, c.r) * d.y + c.gba * d.z) * (1.5 / PI);
    return TerrainAir(share, wide, mean, first / mean);
}

#endif
