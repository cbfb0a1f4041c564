// Looking into the shadow ceiling (interop/shadow_ceiling.h). A sun ray keeps `across` and `over`, so a place is in
// shadow where terrain nearer to the sun in its column has a higher `over`; the map's down-sun edge holds for all that
// lies behind.
#ifndef ALPENGLOW_ATMOSPHERE_SHADOW_CEILING_GLSL
#define ALPENGLOW_ATMOSPHERE_SHADOW_CEILING_GLSL
#include "atmosphere/sun_share.glsl"
#include "interop/shadow_ceiling.h"
SHADER_NAMESPACE_BEGIN

struct CeilingPlace {
    vec2 uv;
    float over;  // [m]
    float along; // [m]
};

// `light`: in the sun's frame, from the camera [m].
INLINE CeilingPlace ceiling_place(IN(ShadowCeiling) ceiling, vec3 light) {
    vec2 plane = vec2(light.x, light.y);
    float across = dot(ceiling.light_across, plane) + ceiling.camera.x;
    float over = dot(ceiling.light_over, plane) + ceiling.camera.y;
    float along = ceiling.camera.z - light.z;
    float sunward = along * ceiling.sun.x - over * ceiling.sun.y;
    return CeilingPlace(vec2(across, sunward) * ceiling.scale + ceiling.offset, over, along);
}

// Of a surface. It doesn't shade itself: its own place in the map is passed over, along the ray to the sun.
INLINE CeilingPlace ceiling_surface_place(IN(ShadowCeiling) ceiling, vec3 light) {
    CeilingPlace place = ceiling_place(ceiling, light);
    place.uv.y -= 2.0f * ceiling.texel_v;
    return place;
}

// The share of the sun's disc that the terrain leaves, 0 to 1. The caster's edge counts as straight; nearer than a texel
// none is known.
INLINE float ceiling_visibility(sampler2D map, IN(ShadowCeiling) ceiling, IN(CeilingPlace) place) {
    vec4 caster = sample_bilinear(map, place.uv);
    float above = place.over - caster.x;
    float half_width = max(caster.y - place.along, ceiling.texel) * ceiling.sun_tangent;
    float lit = disc_share_above(above / half_width);
    return above < -ceiling.deepest ? 1.0f : lit;
}

SHADER_NAMESPACE_END
#endif
