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

// Distances from the camera [m] of a ray; empty where end <= begin.
struct Span {
    float begin, end;
};

Span crossed(Span a, Span b) { return Span(max(a.begin, b.begin), min(a.end, b.end)); }

Span moved(Span span, float by) { return Span(span.begin + by, span.end + by); }

// Where a line a + b t lies between 0 and 1.
Span unit_span(float a, float b) {
    float slope = abs(b) < 1e-20 ? 1e-20 : b;
    float t0 = -a / slope, t1 = (1.0 - a) / slope;
    return Span(min(t0, t1), max(t0, t1));
}

// Where a ray in the sun's direction `light` is further inside a cascade than the share `margin` of its half width.
Span span_inside(Cascade cascade, vec3 light, float margin) {
    vec2 from = (cascade.offset - 0.5 * margin) / (1.0 - margin), slope = light.xy * cascade.scale / (1.0 - margin);
    return crossed(unit_span(from.x, slope.x), unit_span(from.y, slope.y));
}

// A ray in the sun's frame, and where on it each cascade serves.
struct ShaftRay {
    vec3 light;                   // unit
    Span held[MOST_CASCADES - 1]; // by the finer ones
    Span near;                    // by the last one before it fades
};

ShaftRay make_shaft_ray(vec3 light) {
    ShaftRay ray;
    ray.light = light;
    for (int i = 0; i < MOST_CASCADES - 1; ++i) ray.held[i] = span_inside(frame.cascades[i], light, AIR_MARGIN);
    ray.near = span_inside(frame.cascades[MOST_CASCADES - 1], light, frame.shadow_fade);
    return ray;
}

bool holds(Span span, float begin, float end) { return span.begin <= begin && end <= span.end; }

// A stretch of a ray in a cascade: texture coordinates and depth.
struct Stretch {
    vec3 from, along;
    float layer;
};

// In the finest cascade that holds it; else in the last.
Stretch stretch_between(ShaftRay ray, float begin, float end) {
    int index = MOST_CASCADES - 1;
    for (int i = MOST_CASCADES - 2; i >= 0; --i)
        if (holds(ray.held[i], begin, end)) index = i;
    Cascade cascade = frame.cascades[index];
    vec3 slope = ray.light * vec3(cascade.scale, cascade.scale, frame.light_depth.x);
    Stretch stretch;
    stretch.from = vec3(cascade.offset, frame.light_depth.y) + begin * slope;
    stretch.along = (end - begin) * slope;
    stretch.layer = float(min(index, frame.cascade_count - 1));
    return stretch;
}

// Least and greatest depth of the texels of a stretch.
vec2 bounds_around(Stretch stretch) {
    int size = textureSize(shadow_cascades, 0).x, side = bounds_side(textureSize(shadow_bounds, 0).x);
    vec2 a = stretch.from.xy, b = stretch.from.xy + stretch.along.xy;
    ivec2 low = ivec2(clamp(min(a, b), 0.0, 1.0) * float(size) - 0.01), high = ivec2(clamp(max(a, b), 0.0, 1.0) * float(size) + 0.01);
    int extent = max(high.x - low.x, high.y - low.y);
    int level = clamp(findMSB(extent / SHADOW_BLOCK) + 1, 0, findMSB(side));
    ivec2 block = min(low, ivec2(size - 1)) >> (findMSB(SHADOW_BLOCK) + level);
    return texelFetch(shadow_bounds, bounds_origin(side, level, int(stretch.layer)) + block, 0).rg;
}

float look(Stretch stretch, float x) {
    vec3 at = stretch.from + x * stretch.along;
    return shadow_look(vec4(at.xy, stretch.layer, clamp(at.z, 0.0, 1.0)));
}

void add_look(inout Seen seen, float v, float x) {
    seen.mean += v;
    seen.slope += v * (x - 0.5);
}

// Of a stretch between two distances [m] from the camera before the last cascade fades, by `frame.shaft_looks` at even places, each at
// the share `dither` of its part. Stretches that are lit or dark as a whole cost one look.
Seen seen_near(ShaftRay ray, float begin, float end, float dither) {
    Stretch stretch = stretch_between(ray, begin, end);
    vec2 bounds = bounds_around(stretch);
    float z0 = clamp(stretch.from.z, 0.0, 1.0), z1 = clamp(stretch.from.z + stretch.along.z, 0.0, 1.0);
    bool lit = max(z0, z1) <= bounds.x, dark = min(z0, z1) > bounds.y;
    float part = 1.0 / float(frame.shaft_looks), x = dither * part;
    Seen seen = Seen(0.0, 0.0);
    int i = 0;
    do {
        add_look(seen, look(stretch, x), x);
        x += part;
    } while (subgroupAny(!lit && !dark && ++i < frame.shaft_looks));
    if (lit || dark) return Seen(lit ? 1.0 : 0.0, 0.0);
    return Seen(seen.mean * part, seen.slope * part);
}

// The same where the last cascade fades and beyond it. `shaded`: where on the ray meshes can shade it.
Seen seen_beyond(ShaftRay ray, Span shaded, float begin, float end, float dither) {
    bool lit = end <= shaded.begin || begin >= shaded.end;
    float part = 1.0 / float(frame.shaft_looks), x = dither * part;
    Seen seen = Seen(0.0, 0.0);
    int i = 0;
    do {
        add_look(seen, last_visibility(ray.light * mix(begin, end, x)), x);
        x += part;
    } while (subgroupAny(!lit && ++i < frame.shaft_looks));
    if (lit) return Seen(1.0, 0.0);
    return Seen(seen.mean * part, seen.slope * part);
}

#endif
