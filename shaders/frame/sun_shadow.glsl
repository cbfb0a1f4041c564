// Looking into the shadow cascades, and beyond them into the shadow ceiling. A cascade is chosen without branches or loops: they are
// nested, so the finest that holds a place is the first. Reads its includer's `frame`, `shadow_cascades` and `ceiling_map`.
#ifndef ALPENGLOW_FRAME_SUN_SHADOW
#define ALPENGLOW_FRAME_SUN_SHADOW
#include "atmosphere/shadow_ceiling.glsl"
#include "interop/frame.h"

// 1 where a place in a cascade (texture coordinates, layer, depth) is lit. The air's rays look at so many that single texels will do.
#ifdef LIGHT_OF_RAYS
float shadow_look(vec4 at) {
    ivec3 texel = ivec3(at.xy * float(textureSize(shadow_cascades, 0).x), int(at.z));
    return at.w <= texelFetch(shadow_cascades, texel, 0).r ? 1.0 : 0.0;
}
#else
float shadow_look(vec4 at) { return texture(shadow_cascades, at); }
#endif

// A place in the cascade that was chosen for it.
struct CascadePlace {
    vec2 uv;
    float layer;
    float texel;      // [m]
    float texel_uv;   // the same in texture coordinates
    float inside;     // 1 at the cascade's centre, 0 at its edge
    float last_inside; // the same for the last cascade
};

vec2 cascade_uv(Cascade cascade, vec2 light) { return light * cascade.scale + cascade.offset; }

// How far inside a cascade: 1 at the centre, 0 at the edge, negative outside.
float inside_cascade(vec2 uv) {
    vec2 from_centre = abs(uv - 0.5);
    return 1.0 - 2.0 * max(from_centre.x, from_centre.y);
}

CascadePlace place_in(Cascade cascade, float layer, vec2 uv) {
    return CascadePlace(uv, layer, cascade.texel, cascade.texel * cascade.scale, inside_cascade(uv), 0.0);
}

// The finest cascade from `first` on that holds `light` [m], a place in the sun's frame, with `margin` to spare; else the last.
CascadePlace choose_cascade(vec2 light, float margin, float first) {
    vec2 uv0 = cascade_uv(frame.cascades[0], light), uv1 = cascade_uv(frame.cascades[1], light);
    vec2 uv2 = cascade_uv(frame.cascades[2], light), uv3 = cascade_uv(frame.cascades[3], light);
    CascadePlace place = place_in(frame.cascades[3], 3.0, uv3);
    float last_inside = place.inside;
    if (first <= 2.0 && inside_cascade(uv2) > margin) place = place_in(frame.cascades[2], 2.0, uv2);
    if (first <= 1.0 && inside_cascade(uv1) > margin) place = place_in(frame.cascades[1], 1.0, uv1);
    if (first <= 0.0 && inside_cascade(uv0) > margin) place = place_in(frame.cascades[0], 0.0, uv0);
    place.layer = min(place.layer, float(frame.cascade_count - 1));
    place.last_inside = last_inside;
    return place;
}

// What lies behind the whole scene is compared as if it stood at the scene's far end: a float depth isn't clamped by itself,
// and the cleared depth of 1 would shade it.
float light_depth(float z) { return clamp(z * frame.light_depth.x + frame.light_depth.y, 0.0, 1.0); }

// The ceiling takes over at the cascades' reach; the change is spread over a margin.
float handed_over(float in_cascade, float in_ceiling, float last_inside) {
    return mix(in_ceiling, in_cascade, clamp(last_inside / frame.shadow_fade, 0.0, 1.0));
}

float seen_at(CascadePlace place, vec3 light) {
    float lit = shadow_look(vec4(place.uv, place.layer, light_depth(light.z)));
    float in_ceiling = ceiling_visibility(ceiling_map, frame.ceiling, ceiling_place(frame.ceiling, light));
    return handed_over(lit, in_ceiling, place.last_inside);
}

const float AIR_MARGIN = 0.004; // of a cascade's half width: nothing that the air's looks touch lies outside

// 1 where the sun reaches a place in the air, 0 in shadow. `light`: in the sun's frame, from the camera [m].
float air_visibility(vec3 light) { return seen_at(choose_cascade(light.xy, AIR_MARGIN, 0.0), light); }

// The same by the last cascade alone.
float last_visibility(vec3 light) {
    Cascade last = frame.cascades[MOST_CASCADES - 1];
    CascadePlace place = place_in(last, float(frame.cascade_count - 1), cascade_uv(last, light.xy));
    place.last_inside = place.inside;
    return seen_at(place, light);
}

// Texture coordinates and depth in a cascade of a surface that is moved out along its normal by as much as the filter reaches at its
// slope, so that it does not shade itself.
vec3 moved_out(CascadePlace place, vec3 light, vec3 light_normal) {
    float cosine = clamp(-light_normal.z, 0.0, 1.0);
    vec3 moved = light_normal * (place.texel * (0.4 + 1.6 * sqrt(1.0 - cosine * cosine)));
    return vec3(place.uv + moved.xy * (place.texel_uv / place.texel), light_depth(light.z + moved.z));
}

// 3x3 comparisons of a surface against a cascade.
float surface_visibility_in(CascadePlace place, vec3 light, vec3 light_normal) {
    vec3 moved = moved_out(place, light, light_normal);
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) lit += shadow_look(vec4(moved.xy + vec2(x, y) * place.texel_uv, place.layer, moved.z));
    }
    return lit / 9.0;
}

const float SURFACE_MARGIN = 0.01; // of a cascade's half width: room for the filter
const float SURFACE_BLEND = 0.1;   // over which one cascade goes over into the next

// 1 in the sun, 0 in shadow, blended from one cascade to the next.
float surface_visibility(vec3 light, vec3 light_normal) {
    CascadePlace near = choose_cascade(light.xy, SURFACE_MARGIN, 0.0);
    CascadePlace far = choose_cascade(light.xy, SURFACE_MARGIN, near.layer + 1.0);
    float share = clamp((near.inside - SURFACE_MARGIN) / SURFACE_BLEND, 0.0, 1.0);
    // One comparison of the coarser cascade, which the sampler filters over two of its texels, is as soft as nine of the finer one.
    vec3 moved = moved_out(far, light, light_normal);
    float far_lit = shadow_look(vec4(moved.xy, far.layer, moved.z));
    float in_cascade = mix(far_lit, surface_visibility_in(near, light, light_normal), share);
    float in_ceiling = ceiling_visibility(ceiling_map, frame.ceiling, ceiling_surface_place(frame.ceiling, light));
    return handed_over(in_cascade, in_ceiling, near.last_inside);
}

#endif
