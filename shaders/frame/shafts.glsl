// How much of the sun stretches of a ray see. Included by passes that have the shadow cascades and their bounds: reads `frame`,
// `shadow_cascades` and `shadow_bounds`.
#ifndef ALPENGLOW_FRAME_SHAFTS
#define ALPENGLOW_FRAME_SHAFTS
#include "frame/sun_shadow.glsl"
#include "interop/shadow_bounds.h"

// The share v of the sun that is seen along a stretch, with x from 0 at its beginning to 1 at its end.
struct Seen {
    float mean;  // of v
    float slope; // mean of v (x - 1/2)
};

// A stretch of a ray in a cascade: texture coordinates and depth, and how far inside the last cascade.
struct Stretch {
    vec3 from, along;
    float layer;
    vec2 last_from, last_along;
};

// The finest cascade that holds both ends [m], in the sun's frame; else the last.
Stretch stretch_between(vec3 a, vec3 b) {
    int index = MOST_CASCADES - 1;
    for (int i = MOST_CASCADES - 2; i >= 0; --i) {
        vec2 from = cascade_uv(frame.cascades[i], a.xy), to = cascade_uv(frame.cascades[i], b.xy);
        if (min(inside_cascade(from), inside_cascade(to)) > 0.004) index = i;
    }
    Cascade cascade = frame.cascades[index], last = frame.cascades[MOST_CASCADES - 1];
    Stretch stretch;
    stretch.from = vec3(cascade_uv(cascade, a.xy), a.z * frame.light_depth.x + frame.light_depth.y);
    stretch.along = vec3((b.xy - a.xy) * cascade.scale, (b.z - a.z) * frame.light_depth.x);
    stretch.layer = float(min(index, frame.cascade_count - 1));
    stretch.last_from = cascade_uv(last, a.xy);
    stretch.last_along = (b.xy - a.xy) * last.scale;
    return stretch;
}

// Least and greatest depth of the texels that looks at the stretch may filter, of four blocks of a size that they fit into.
vec2 bounds_around(Stretch stretch) {
    int size = textureSize(shadow_cascades, 0).x, side = textureSize(shadow_bounds, 0).x * 2 / 3;
    vec2 a = stretch.from.xy * float(size), b = a + stretch.along.xy * float(size);
    ivec2 low = clamp(ivec2(floor(min(a, b) - 0.5)), ivec2(0), ivec2(size - 1));
    ivec2 high = clamp(ivec2(floor(max(a, b) + 0.5)), ivec2(0), ivec2(size - 1));
    int extent = max(high.x - low.x, high.y - low.y); // of one less than their number
    int level = clamp(findMSB(extent / SHADOW_BLOCK) + 1, 0, findMSB(side));
    int shift = findMSB(SHADOW_BLOCK) + level;
    ivec2 origin = bounds_origin(side, level, int(stretch.layer));
    ivec2 first = origin + (low >> shift), second = origin + (high >> shift);
    vec2 n00 = texelFetch(shadow_bounds, first, 0).rg, n10 = texelFetch(shadow_bounds, ivec2(second.x, first.y), 0).rg;
    vec2 n01 = texelFetch(shadow_bounds, ivec2(first.x, second.y), 0).rg, n11 = texelFetch(shadow_bounds, second, 0).rg;
    return vec2(min(min(n00.x, n10.x), min(n01.x, n11.x)), max(max(n00.y, n10.y), max(n01.y, n11.y)));
}

float look(Stretch stretch, float x) {
    vec3 at = stretch.from + x * stretch.along;
    float lit = texture(shadow_cascades, vec4(at.xy, stretch.layer, clamp(at.z, 0.0, 1.0)));
    return faded(lit, inside_cascade(stretch.last_from + x * stretch.last_along));
}

// Of the stretch between two distances [m] of a ray in the sun's direction `light`, from the camera on. Stretches that are lit or dark as a
// whole cost no more than one look, others `frame.shaft_looks` at even places, each at the share `dither` of its part.
Seen seen_between(vec3 light, float begin, float end, float dither) {
    Stretch stretch = stretch_between(light * begin, light * end);
    vec2 bounds = bounds_around(stretch);
    float z0 = clamp(stretch.from.z, 0.0, 1.0), z1 = clamp(stretch.from.z + stretch.along.z, 0.0, 1.0);
    bool lit = max(z0, z1) <= bounds.x, dark = min(z0, z1) > bounds.y;
    bool within = min(inside_cascade(stretch.last_from), inside_cascade(stretch.last_from + stretch.last_along)) >= frame.shadow_fade;
    bool known = within && (lit || dark);

    float part = 1.0 / float(frame.shaft_looks), x = dither * part;
    Seen seen = Seen(0.0, 0.0);
    int i = 0;
    do {
        float v = look(stretch, x);
        seen.mean += v;
        seen.slope += v * (x - 0.5);
        x += part;
    } while (subgroupAny(!known && ++i < frame.shaft_looks));
    if (known) return Seen(lit ? 1.0 : 0.0, 0.0);
    return Seen(seen.mean * part, seen.slope * part);
}

#endif
