// Where to put the samples of a ray: cells even in sqrt(1 - exp(-(h - h_p) / H)), signed, on both sides of the ray's
// closest approach at altitude h_p. That is even in distance near the closest approach and even in exp(-h / H) far
// from it. Written from the segment's lowest point, in sums of terms of one sign, so that it is as accurate for
// centimetres as for the whole limb, for vertical rays as for horizontal ones.
#ifndef ALPENGLOW_ATMOSPHERE_MARCH_SAMPLES_GLSL
#define ALPENGLOW_ATMOSPHERE_MARCH_SAMPLES_GLSL
#include "atmosphere/geometry.glsl"
SHADER_NAMESPACE_BEGIN

// H over the top altitude: 40 km on Earth. 30 to 50 km do as well; 8 and 16 km fail in twilight.
CONSTANT float QUANTILE_HEIGHT = 0.4f;

// The cells of a segment. With x = h - lowest altitude, p = 1 - exp(-x / H) and k = `offset`, the measure of a point is
// d = sqrt(k² + (1 - k²) p) - k over 1 - k², negative before the lowest point.
struct MarchCells {
    float begin;         // distance from the ray's origin [m]
    float end;           // [m]
    float lowest;        // distance of the segment's lowest point [m]
    float lowest_radius; // its distance from the planet's centre [m]
    float lowest_along;  // its distance from the closest approach [m], 0 where that lies inside the segment
    float height;        // H [m]
    float offset;        // k: sqrt(1 - exp(-(lowest altitude - h_p) / H))
    float measure_begin; // d at both ends; d grows along the ray
    float measure_end;
};

// One cell: distances from the ray's origin [m].
struct MarchCell {
    float begin;
    float middle; // where to evaluate
    float end;
};

// d at a distance [m] from the lowest point.
INLINE float measure_from_travel(MarchCells cells, float travel) {
    float power = travel * (2.0f * cells.lowest_along + travel);
    float rise = power / (cells.lowest_radius + sqrt(cells.lowest_radius * cells.lowest_radius + power));
    float p = one_minus_exp(rise / cells.height);
    float k2 = cells.offset * cells.offset;
    return p / max(cells.offset + sqrt(k2 + (1.0f - k2) * p), TINY);
}

// Distance [m] from the lowest point, for d >= 0.
INLINE float travel_from_measure(MarchCells cells, float d) {
    float k2 = cells.offset * cells.offset;
    float p = min(d * (2.0f * cells.offset + (1.0f - k2) * d), 0.999999f);
    float rise = cells.height * minus_log_one_minus(p);
    float power = rise * (2.0f * cells.lowest_radius + rise);
    return power / max(cells.lowest_along + sqrt(cells.lowest_along * cells.lowest_along + power), TINY);
}

// The cells between distances `begin` <= `end` [m] of a ray, both inside the air.
INLINE MarchCells make_march_cells(Atmosphere atmosphere, AirRay ray, float begin, float end) {
    MarchCells cells;
    cells.begin = begin;
    cells.end = end;
    cells.lowest = clamp(-ray.along, begin, end);
    cells.lowest_radius = ray.ground_radius + altitude_at(ray, cells.lowest);
    cells.lowest_along = min(abs(ray.along + cells.lowest), cells.lowest_radius);
    cells.height = QUANTILE_HEIGHT * atmosphere.top_altitude;
    float r2 = cells.lowest_radius * cells.lowest_radius;
    float along2 = cells.lowest_along * cells.lowest_along;
    float above_closest = along2 / (cells.lowest_radius + sqrt(r2 - along2));
    cells.offset = sqrt(one_minus_exp(above_closest / cells.height));
    cells.measure_begin = -measure_from_travel(cells, cells.lowest - begin);
    cells.measure_end = measure_from_travel(cells, end - cells.lowest);
    return cells;
}

// Distance from the ray's origin [m] of the share u of the segment's measure; exactly `begin` at 0 and `end` at 1.
INLINE float march_distance(MarchCells cells, float u) {
    float d = mix(cells.measure_begin, cells.measure_end, u);
    float travel = travel_from_measure(cells, abs(d));
    float t = clamp(cells.lowest + (d < 0.0f ? -travel : travel), cells.begin, cells.end);
    return u <= 0.0f ? cells.begin : (u >= 1.0f ? cells.end : t);
}

// The i-th of n cells, for a loop that knows where the one before ended. Neighbours share their edge to the bit, so
// that the lengths add up to the segment's.
INLINE MarchCell march_cell_from(MarchCells cells, float from, int i, int n) {
    return MarchCell(from, march_distance(cells, (float(i) + 0.5f) / float(n)),
                     march_distance(cells, float(i + 1) / float(n)));
}

// The i-th of n cells.
INLINE MarchCell march_cell(MarchCells cells, int i, int n) {
    return march_cell_from(cells, march_distance(cells, float(i) / float(n)), i, n);
}

SHADER_NAMESPACE_END
#endif
