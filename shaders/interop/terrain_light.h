// Light from all round on a scene's terrain, which hides the sky from itself and lights itself: a square map of the scene from
// above, in axes of its own: x and y level, z up, from the scene's origin [m]. docs/terrain_light.md.
// Pass `terrain_above`: the G-buffer of the scene from above; depth grows with the height. Row 0 is at the largest y.
// Pass `terrain_sky`: rgba32f, radiance of sky and planet without terrain: a column for each azimuth and band of
// elevations, a row for each height, in tiles one above the other: where terrain shades the air from the place on for so far.
// Pass `terrain_glow`: rgba32f, radiance of the terrain under sun and open sky; alpha: its height z [m].
// `terrain_facing`: rgba16f, its normal in the map's axes.
// Pass `terrain_light`: rgba16f in tiles one above the other, irradiance as ten spherical harmonics of three channels
// in the map's axes; in the last tile also the height as depth has it, and the mean rise of the horizon above it [m].
// Pass `terrain_air`: the first three and the last of these tiles, coarser.
// Radiance and irradiance are per unit of the sun's above the air.
#ifndef ALPENGLOW_INTEROP_TERRAIN_LIGHT_H
#define ALPENGLOW_INTEROP_TERRAIN_LIGHT_H
#include "interop/language.h"

#define TERRAIN_AZIMUTHS 8
#define TERRAIN_BANDS 11
#define TERRAIN_ALTITUDES 8
#define TERRAIN_SHADES 7        // from 0 on; the n-th is TERRAIN_SHADE * (2^n - 1) [m]
#define TERRAIN_SHADE 500.0
#define TERRAIN_LIGHT_TILES 8
#define TERRAIN_AIR_TILES 4
#define TERRAIN_AIR_TEXELS 8 // of the light, to each side of a texel of the air's

#define TERRAIN_SKY_SUNLIGHT_SLOT 1 // in, tables: linear filter, clamped to the edge
#define TERRAIN_SKY_ORDERS_SLOT 2        // in, light of all orders
#define TERRAIN_SKY_RESULT_SLOT 3        // out

#define TERRAIN_GLOW_SUNLIGHT_SLOT 1 // in, as above
#define TERRAIN_GLOW_ORDERS_SLOT 2
#define TERRAIN_GLOW_ALBEDO_SLOT 3        // in, from above: interop/gbuffer.h
#define TERRAIN_GLOW_NORMAL_SLOT 4
#define TERRAIN_GLOW_DEPTH_SLOT 5
#define TERRAIN_GLOW_CEILING_SLOT 6       // in, interop/shadow_ceiling.h
#define TERRAIN_GLOW_RESULT_SLOT 7        // out
#define TERRAIN_GLOW_FACING_SLOT 8

#define TERRAIN_LIGHT_SKY_SLOT 1    // in, linear filter, clamped to the edge
#define TERRAIN_LIGHT_GLOW_SLOT 2   // in
#define TERRAIN_LIGHT_FACING_SLOT 3 // in
#define TERRAIN_LIGHT_RESULT_SLOT 4 // out
#define TERRAIN_LIGHT_CEILING_SLOT 5 // in, interop/shadow_ceiling.h

#define TERRAIN_AIR_LIGHT_SLOT 1  // in, linear filter, clamped to the edge
#define TERRAIN_AIR_RESULT_SLOT 2 // out

SHADER_NAMESPACE_BEGIN

// Where the map lies.
struct TerrainMap {
    vec3 x, y, z;   // its axes, unit, world
    vec3 origin;    // from the camera, world axes [m]
    vec2 lowest;    // (x, y) of its corner [m]
    float texel;    // [m]
    float bottom;   // z = bottom + depth * range [m]
    float range;
    float altitude; // of the origin [m]
    int size;       // [texels]; 0: no map
};
CHECK_SIZE(TerrainMap, 76);

SHADER_NAMESPACE_END

#endif
