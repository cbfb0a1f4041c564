// Looking into the shadow cascades. A cascade is chosen without branches: they are nested, so that the number of those that
// a place lies outside of is the index of the first that holds it.
#ifndef ALPENGLOW_FRAME_SUN_SHADOW
#define ALPENGLOW_FRAME_SUN_SHADOW
#include "interop/frame.h"

// Place across the sun's rays in cascade i, 0 to 1.
vec2 cascade_uv(FrameConstants frame, int i, vec2 light) { return light * frame.cascades[i].scale + frame.cascades[i].offset; }

// How far inside cascade i: 1 at the centre, 0 at the edge, negative outside.
float cascade_depth_inside(FrameConstants frame, int i, vec2 light) {
    vec2 from_centre = abs(cascade_uv(frame, i, light) - 0.5);
    return 1.0 - 2.0 * max(from_centre.x, from_centre.y);
}

// The first cascade that holds the place; cascade_count where none does.
int cascade_of(FrameConstants frame, vec2 light, float margin) {
    int outside = 0;
    for (int i = 0; i < MOST_CASCADES; ++i) {
        outside += i < frame.cascade_count && cascade_depth_inside(frame, i, light) < margin ? 1 : 0;
    }
    return outside;
}

// What lies behind the whole scene is compared as if it stood at the scene's far end: a float depth isn't clamped by itself,
// and the cleared depth of 1 would shade it.
float light_depth(FrameConstants frame, float z) { return clamp(z * frame.light_depth.x + frame.light_depth.y, 0.0, 1.0); }

// 1 where the sun reaches a place in the air, 0 in shadow; fades to lit at the cascades' reach. `light`: in the sun's frame.
float air_visibility(FrameConstants frame, sampler2DArrayShadow cascades, vec3 light) {
    int last = frame.cascade_count - 1;
    int chosen = min(cascade_of(frame, light.xy, 0.004), last);
    float lit = texture(cascades, vec4(cascade_uv(frame, chosen, light.xy), float(chosen), light_depth(frame, light.z)));
    float edge = clamp(cascade_depth_inside(frame, last, light.xy) / frame.shadow_fade, 0.0, 1.0);
    return mix(1.0, lit, edge);
}

// 3x3 comparisons of a surface against cascade i. The surface is moved out along its normal by as much as the filter reaches
// at its slope, so that it does not shade itself.
float surface_visibility_in(FrameConstants frame, sampler2DArrayShadow cascades, int i, vec3 light, vec3 light_normal) {
    float cosine = clamp(-light_normal.z, 0.0, 1.0);
    float sine = sqrt(1.0 - cosine * cosine);
    vec3 moved = light + light_normal * (frame.cascades[i].texel * (0.4 + 1.6 * sine));
    vec2 uv = cascade_uv(frame, i, moved.xy);
    vec2 texel = frame.cascades[i].texel * frame.cascades[i].scale;
    float depth = light_depth(frame, moved.z);
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) lit += texture(cascades, vec4(uv + vec2(x, y) * texel, float(i), depth));
    }
    return lit / 9.0;
}

// 1 in the sun, 0 in shadow, blended from one cascade to the next over a tenth of its width.
float surface_visibility(FrameConstants frame, sampler2DArrayShadow cascades, vec3 light, vec3 light_normal) {
    const float BLEND = 0.1, MARGIN = 0.01;
    int last = frame.cascade_count - 1;
    int near = min(cascade_of(frame, light.xy, MARGIN), last);
    int far = min(near + 1, last);
    float inside = clamp((cascade_depth_inside(frame, near, light.xy) - MARGIN) / BLEND, 0.0, 1.0);
    float lit = mix(surface_visibility_in(frame, cascades, far, light, light_normal),
                    surface_visibility_in(frame, cascades, near, light, light_normal), near == last ? 1.0 : inside);
    float edge = clamp(cascade_depth_inside(frame, last, light.xy) / frame.shadow_fade, 0.0, 1.0);
    return mix(1.0, lit, edge);
}

#endif
