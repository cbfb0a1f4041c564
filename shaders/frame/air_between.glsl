// The air's light between pixels whose light is known, and how far off that may be. Included by the pass `air_fill`, whose
// `push` it reads.
#ifndef ALPENGLOW_FRAME_AIR_BETWEEN
#define ALPENGLOW_FRAME_AIR_BETWEEN
#include "atmosphere/segment_integral.glsl"
#include "encoding/color.glsl"
#include "frame/pixel_depth.glsl"

// Shares of the picture's mean: an error in fainter air is judged as if its light were the first, in brighter air as if the second.
const float FAINT = 0.25, BRIGHT = 2.0;

// What is known at the corners of a cell: 00 10 01 11, x first. Bends are second differences along its edges, as interpolation
// takes them (`curve`), and as they bound its error (`doubt`).
struct CellPart {
    vec3 corner[4];
    vec3 curve_x[2], curve_y[2];
    vec3 doubt;
};

struct CoarseCell {
    CellPart inscattered, transmittance;
    vec4 depth; // of the corners, reversed
};

// The second difference of four values in a row that suits their middle: the flatter of both, so that a step beyond the middle does
// not bend it. `doubt` grows to what a cubic through values that are not smooth may be off by: half of a step between the middle two.
vec3 bend(vec3 before, vec3 a, vec3 b, vec3 behind, inout vec3 doubt) {
    vec3 first = before - 2.0 * a + b, second = a - 2.0 * b + behind;
    vec3 flatter = min(abs(first), abs(second));
    bvec3 opposite = lessThan(first * second, vec3(0.0));
    doubt = max(doubt, flatter * mix(vec3(0.25), vec3(0.5), opposite));
    return mix(flatter * sign(first), vec3(0.0), opposite);
}

CellPart read_part(sampler2D image, ivec2 at) {
    ivec2 last = textureSize(image, 0) - 1;
    vec3 t[12]; // the 4x4 texels around the cell without their corners, row by row
    for (int i = 0; i < 12; ++i) {
        int place = i < 2 ? i + 1 : (i < 10 ? i + 2 : i + 3);
        t[i] = texelFetch(image, clamp(at + ivec2(place & 3, place >> 2) - 1, ivec2(0), last), 0).rgb;
    }
    CellPart part;
    part.corner = vec3[](t[3], t[4], t[7], t[8]);
    part.doubt = vec3(0.0);
    part.curve_x = vec3[](bend(t[2], t[3], t[4], t[5], part.doubt), bend(t[6], t[7], t[8], t[9], part.doubt));
    part.curve_y = vec3[](bend(t[0], t[3], t[7], t[10], part.doubt), bend(t[1], t[4], t[8], t[11], part.doubt));
    return part;
}

CoarseCell read_coarse_cell(ivec2 at, int stride) {
    CoarseCell cell;
    cell.inscattered = read_part(coarse_inscattered, at);
    cell.transmittance = read_part(coarse_transmittance, at);
    for (int i = 0; i < 4; ++i) cell.depth[i] = pixel_depth((at + ivec2(i & 1, i >> 1)) * stride);
    return cell;
}

vec3 between(CellPart part, vec2 share) {
    vec3 linear = mix(mix(part.corner[0], part.corner[1], share.x), mix(part.corner[2], part.corner[3], share.x), share.y);
    vec2 bow = 0.5 * share * (1.0 - share);
    return linear - bow.x * mix(part.curve_x[0], part.curve_x[1], share.y) - bow.y * mix(part.curve_y[0], part.curve_y[1], share.x);
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

const float ONE_SURFACE = 1.5; // depths of a surface's corners differ by less than this factor, but for the last pixels before its horizon

// By how much the share `through` that even air lets pass changes where a surface has one reversed depth in place of another.
float change(float through, float depth, float other) { return abs(pow(through, min(other / max(depth, TINY), 100.0)) - through); }

// The same for a pixel's depth in place of those at the corners: where they are one surface, in place of its plane's, which is linear.
float depth_change(vec4 corners, vec2 share, float depth, float through) {
    float nearest = max(max(corners.x, corners.y), max(corners.z, corners.w));
    float farthest = min(min(corners.x, corners.y), min(corners.z, corners.w));
    float plane = mix(mix(corners.x, corners.y, share.x), mix(corners.z, corners.w, share.x), share.y);
    if (depth == 0.0 && nearest == 0.0) return 0.0;
    if (nearest < ONE_SURFACE * farthest) return change(through, depth, plane);
    return max(change(through, depth, nearest), change(through, depth, farthest));
}

const float AIR_END = 8.0; // tuned

// Whether light falls that much from one corner to another, as it does where the air ends. Beyond it is black, and metrics of wide range
// see what comes there from beside it, however faint.
bool at_the_airs_end(CellPart inscattered) {
    float least = largest(inscattered.corner[0]), most = least;
    for (int i = 1; i < 4; ++i) {
        float light = largest(inscattered.corner[i]);
        least = min(least, light);
        most = max(most, light);
    }
    return most > AIR_END * least;
}

// The light at a share of the cell whose surface has that depth; `mean`: the air's luminance over the picture. `error` over 1: not good enough.
AirLight air_between(CoarseCell cell, vec2 share, float depth, float mean, out float error) {
    // A bow over a steep edge can lead below 0.
    AirLight air = AirLight(max(between(cell.inscattered, share), vec3(0.0)), max(between(cell.transmittance, share), vec3(0.0)));
    float bright = clamp(luminance(air.inscattered), max(FAINT * mean, TINY), max(BRIGHT * mean, TINY));
    float doubt = max(largest(cell.inscattered.doubt) / bright, largest(cell.transmittance.doubt));

    float through = clamp(luminance(air.transmittance), 1e-4, 0.9999); // 0 to the power of 0 is no number
    float off = depth_change(cell.depth, share, depth, through);
    doubt = max(doubt, off * max(luminance(air.inscattered) / (bright * (1.0 - through)), 1.0));
    error = at_the_airs_end(cell.inscattered) ? 2.0 : doubt / push.tolerance;
    return air;
}

#endif
