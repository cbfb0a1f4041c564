// How much of the sun stretches of a ray see. Included by passes that have the shadow cascades and their bounds: reads `frame`,
// `shadow_cascades` and `shadow_bounds`.
#ifndef ALPENGLOW_FRAME_SHAFTS
#define ALPENGLOW_FRAME_SHAFTS
#include "frame/march_variant.glsl"
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
    float blur; // by how much the sun's disc moves a look [texture coordinates], for each unit of depth from what casts the shadow
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
    stretch.blur = frame.ceiling.sun_tangent * cascade.scale / frame.light_depth.x;
    return stretch;
}

const bool SOFT_SUN = (MARCH_VARIANT & MARCH_SOFT_SUN) != 0; // otherwise a point
const float MOST_BLUR = 16.0; // [texels] by which a look is moved: wider penumbras end there

float most_blur() { return SOFT_SUN ? MOST_BLUR / float(textureSize(shadow_cascades, 0).x) : 0.0; }

// Of a look at a depth [texture coordinates], past what casts a shadow at another.
float blur_at(Stretch stretch, float depth, float caster) { return clamp((depth - caster) * stretch.blur, 0.0, most_blur()); }

// Least and greatest depth of the texels of a stretch and of those that are nearer to it than `margin` [texture coordinates].
vec2 bounds_around(Stretch stretch, float margin) {
    int size = textureSize(shadow_cascades, 0).x, side = bounds_side(textureSize(shadow_bounds, 0).x);
    vec2 a = stretch.from.xy, b = stretch.from.xy + stretch.along.xy;
    ivec2 low = ivec2(clamp(min(a, b) - margin, 0.0, 1.0) * float(size) - 0.01);
    ivec2 high = ivec2(clamp(max(a, b) + margin, 0.0, 1.0) * float(size) + 0.01);
    int extent = max(high.x - low.x, high.y - low.y);
    int level = clamp(findMSB(extent / SHADOW_BLOCK) + 1, 0, findMSB(side));
    ivec2 block = min(low, ivec2(size - 1)) >> (findMSB(SHADOW_BLOCK) + level);
    return texelFetch(shadow_bounds, bounds_origin(side, level, int(stretch.layer)) + block, 0).rg;
}

const int LATTICE_STEP = 5;          // tuned: has no divisor in common with 8 or 24 looks and keeps their points apart
const float GOLDEN_SHARE = 0.618034; // (sqrt(5) - 1) / 2: its multiples, without their whole parts, stay far from each other
const int CELL_STEP = 119;           // slices: GOLDEN_SHARE of all

// The point of the sun's disc that look `i` of `n` of a cell of that number goes to: with the looks' places in the cell a lattice,
// which moves on from cell to cell.
vec2 disc_point(int i, int n, int cell) {
    float across = frame.disc_across[(LATTICE_STEP * i * (DISC_SLICES / n) + CELL_STEP * cell) % DISC_SLICES];
    return vec2(across, sqrt(1.0 - across * across) * (2.0 * fract(GOLDEN_SHARE * float(i + n * cell)) - 1.0));
}

// A look from the share x of a stretch, in a soft sun to a point of its disc, past what casts a shadow at a depth. What the point's
// place along the stretch changes is the less the longer it is: `keep`.
float look(Stretch stretch, float x, float caster, vec2 point, float keep) {
    vec3 at = stretch.from + x * stretch.along;
    if (SOFT_SUN) {
        vec2 along = normalize(stretch.along.xy + 1e-12), across = vec2(-along.y, along.x);
        at.xy += blur_at(stretch, at.z, caster) * (point.x * across + keep * point.y * along);
        at.xy = clamp(at.xy, 0.0, 1.0 - 1e-6);
    }
    return shadow_look(vec4(at.xy, stretch.layer, clamp(at.z, 0.0, 1.0)));
}

void add_look(inout Seen seen, float v, float x) {
    seen.mean += v;
    seen.slope += v * (x - 0.5);
}

const int EDGE_STEPS = 3; // tuned: halvings of the distance of two looks between which the sun is lost or found

// Moves each edge that lies between two looks of a stretch from the middle between them to where it is. Bit i of `lit`: what look i saw.
void find_edges(inout Seen seen, Stretch stretch, uint lit) {
    float part = 1.0 / float(frame.shaft_looks - 1);
    uint edges = (lit ^ lit >> 1) & (1u << (frame.shaft_looks - 1)) - 1u;
    do {
        int i = max(findLSB(edges), 0);
        float near = float(i) * part, far = near + part, middle = near + 0.5 * part, before = float(lit >> i & 1u);
        for (int step = 0; step < EDGE_STEPS; ++step) {
            float x = 0.5 * (near + far);
            bool beyond = look(stretch, x, 0.0, vec2(0.0), 0.0) == before;
            near = beyond ? x : near;
            far = beyond ? far : x;
        }
        float edge = 0.5 * (near + far), moved = edges == 0 ? 0.0 : (2.0 * before - 1.0) * (edge - middle);
        seen.mean += moved;
        seen.slope += moved * (0.5 * (edge + middle) - 0.5);
        edges &= edges - 1u;
    } while (subgroupAny(edges != 0));
}

// Of a stretch between two distances [m] from the camera before the last cascade fades: by looks at even places from its one end to
// the other, and at the edges between them. `cell`: number on the ray. Stretches that are lit or dark as a whole cost one look and an edge's halvings, as loops test at their end.
Seen seen_near(ShaftRay ray, float begin, float end, int cell) {
    Stretch stretch = stretch_between(ray, begin, end);
    float caster = 0.0, blur = 0.0, keep = 0.0;
    if (SOFT_SUN) {
        caster = bounds_around(stretch, most_blur()).x;
        blur = blur_at(stretch, max(stretch.from.z, stretch.from.z + stretch.along.z), caster);
        keep = min(blur / max(length(stretch.along.xy), 1e-12), 1.0);
    }
    vec2 bounds = bounds_around(stretch, blur);
    float z0 = clamp(stretch.from.z, 0.0, 1.0), z1 = clamp(stretch.from.z + stretch.along.z, 0.0, 1.0);
    bool all_lit = max(z0, z1) <= bounds.x, whole = all_lit || min(z0, z1) > bounds.y;
    int last = frame.shaft_looks - 1, i = 0;
    float part = 1.0 / float(last);
    Seen seen = Seen(0.0, 0.0);
    uint lit = 0;
    do {
        float x = float(i) * part, v = look(stretch, x, caster, disc_point(i, frame.shaft_looks, cell), keep);
        add_look(seen, (i == 0 || i == last ? 0.5 : 1.0) * part * v, x);
        lit |= uint(v) << i;
    } while (subgroupAny(!whole) && ++i <= last);
    if (!SOFT_SUN) find_edges(seen, stretch, whole ? 0u : lit);
    return whole ? Seen(all_lit ? 1.0 : 0.0, 0.0) : seen;
}

// The same of the place at a share of it, wherever it is.
float seen_at_place(ShaftRay ray, float begin, float end, float share, int cell) {
    vec3 light = ray.light * mix(begin, end, share);
    if (!SOFT_SUN) return air_visibility(light);
    Stretch stretch = stretch_between(ray, begin, end);
    float caster = bounds_around(stretch, most_blur()).x, in_cascade = 0.0, part = 1.0 / float(frame.shaft_looks);
    int i = 0;
    do in_cascade += part * look(stretch, share, caster, disc_point(i, frame.shaft_looks, cell), 1.0);
    while (++i < frame.shaft_looks);
    float in_ceiling = ceiling_visibility(ceiling_map, frame.ceiling, ceiling_place(frame.ceiling, light));
    return handed_over(in_cascade, in_ceiling, inside_cascade(cascade_uv(frame.cascades[MOST_CASCADES - 1], light.xy)));
}

// The same where the last cascade fades and beyond it. `shaded`: where on the ray meshes can shade it.
Seen seen_beyond(ShaftRay ray, Span shaded, float begin, float end, float dither) {
    bool lit = end <= shaded.begin || begin >= shaded.end;
    float part = 1.0 / float(frame.shaft_looks), x = dither * part;
    Seen seen = Seen(0.0, 0.0);
    int i = 0;
    do {
        add_look(seen, part * last_visibility(ray.light * mix(begin, end, x)), x);
        x += part;
    } while (subgroupAny(!lit) && ++i < frame.shaft_looks);
    return lit ? Seen(1.0, 0.0) : seen;
}

#endif
