// Places and directions of the map of the light on terrain: interop/terrain_light.h.
#ifndef ALPENGLOW_FRAME_TERRAIN_MAP
#define ALPENGLOW_FRAME_TERRAIN_MAP
#include "atmosphere/math.glsl"
#include "interop/frame_block.glsl"

// Bounds of the bands, by the sine of the elevation: closer together where the sky changes most.
const float TERRAIN_BAND_EDGES[TERRAIN_BANDS + 1] =
    float[](-1.0, -0.6, -0.3, -0.12, 0.0, 0.06, 0.14, 0.25, 0.4, 0.58, 0.78, 1.0);

// (x, y) of a texel's middle [m].
vec2 terrain_middle(ivec2 texel) {
    vec2 across = vec2(texel.x, frame.terrain.size - 1 - texel.y) + 0.5;
    return frame.terrain.lowest + across * frame.terrain.texel;
}

// A vector from world axes to the map's.
vec3 terrain_axes(vec3 v) { return vec3(dot(v, frame.terrain.x), dot(v, frame.terrain.y), dot(v, frame.terrain.z)); }

// From the camera, in world axes [m], of a place in the map's (x, y, z).
vec3 terrain_relative(vec2 place, float z) {
    return frame.terrain.origin + frame.terrain.x * place.x + frame.terrain.y * place.y + frame.terrain.z * z;
}

// Without a map outside of it.
vec2 terrain_uv(vec2 place) {
    vec2 at = (place - frame.terrain.lowest) / max(frame.terrain.texel * float(frame.terrain.size), TINY);
    return frame.terrain.size > 0 ? vec2(at.x, 1.0 - at.y) : vec2(0.0);
}

const float TERRAIN_FADE = 0.05; // share of the map's side over which it gives way at its border

// 0 at the border and beyond, to 1.
float terrain_inside(vec2 uv) {
    vec2 inside = clamp(min(uv, 1.0 - uv) / TERRAIN_FADE, 0.0, 1.0);
    return inside.x * inside.y;
}

// One of the tiles that stand one above the other in an image of the map.
vec4 terrain_tile(sampler2D image, vec2 uv, int tile, int tiles) {
    float border = 0.5 / float(textureSize(image, 0).x);
    return textureLod(image, vec2(uv.x, (clamp(uv.y, border, 1.0 - border) + float(tile)) / float(tiles)), 0.0);
}

float terrain_height(float depth) { return frame.terrain.bottom + depth * frame.terrain.range; }

// By how much the planet's sphere has sunk below the level through the origin [m].
float sphere_fall(vec2 place) { return dot(place, place) / (2.0 * frame.atmosphere.ground_radius); }

// Middle of an azimuth's sector, in the map's (x, y).
vec2 terrain_azimuth(float i) {
    float angle = 2.0 * PI * i / float(TERRAIN_AZIMUTHS);
    return vec2(cos(angle), sin(angle));
}

// From the place on [m], the n-th end of the shade on the air, and back.
float terrain_shade(float n) { return TERRAIN_SHADE * (exp2(n) - 1.0); }

float shade_of_distance(float distance) { return min(log2(1.0 + distance / TERRAIN_SHADE), float(TERRAIN_SHADES - 1)); }

#endif
