// The shadow ceiling: terrain's shadow beyond the cascades, as a map of the scene turned to the sun. Places are
// (across, over, along) from the scene's origin [m]: `along` towards the sun, `across` level and `over` upwards, both at
// right angles to the sun's rays. docs/shadow_ceiling.md.
// Pass `terrain_height`: D32, the scene from above; row 0 is the sunward edge, columns lie along the sun's azimuth.
// Pass `shadow_ceiling`: rg32f, of the terrain from the sunward edge to here the highest `over` and its `along` [m].
#ifndef ALPENGLOW_INTEROP_SHADOW_CEILING_H
#define ALPENGLOW_INTEROP_SHADOW_CEILING_H
#include "interop/language.h"

#define CEILING_HEIGHT_SLOT 1 // in, depth from above
#define CEILING_MAP_SLOT 2    // out

#define CEILING_COLUMNS 64    // of a workgroup
#define CEILING_NONE (-1e30f) // `over` where nothing stands between here and the sun

SHADER_NAMESPACE_BEGIN

// What a frame knows of the map.
struct ShadowCeiling {
    vec2 light_across; // across = dot(light_across, light.xy) + camera.x; light: sun's frame, from the camera [m]
    vec2 light_over;   // over likewise, with camera.y
    vec3 camera;       // [m] (across, over, along)
    vec2 sun;          // cosine and sine of the sun's elevation at the scene's origin
    vec2 scale;        // uv = (across, u) * scale + offset, u level towards the sun [1/m]
    vec2 offset;
    float texel;       // [m] the wider side of a texel
    float texel_v;     // a texel towards the sun, in v
    float sun_tangent; // of its angular radius
    float deepest;     // [m] this far below the ceiling nothing is shaded by the terrain but by the planet
};
CHECK_SIZE(ShadowCeiling, 68);

struct ShadowCeilingPush {
    vec2 sun;      // as above
    float top;     // [m] height = top - depth * range
    float range;   // [m]
    float sunward; // [m] u of row 0
    float texel;   // [m] from one row to the next
};

SHADER_NAMESPACE_END
#endif
