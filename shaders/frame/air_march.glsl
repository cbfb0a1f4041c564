// The march from the camera to the surface or out of the air, with the sun's light seen through the shadow cascades.
// A ray is cut in three: before, inside and behind the span where a mesh can shade the air. The span has at least half of
// the samples, evenly; the rest are placed by altitude. Included by the lighting pass, whose images it reads.
#ifndef ALPENGLOW_FRAME_AIR_MARCH
#define ALPENGLOW_FRAME_AIR_MARCH
#include "frame/sun_shadow.glsl"

// Distances from the ray's origin [m]; empty where end <= begin.
struct Span {
    float begin, end;
};

Span crossed(Span a, Span b) { return Span(max(a.begin, b.begin), min(a.end, b.end)); }

// Where a line a + b t lies between 0 and 1.
Span unit_span(float a, float b) {
    float slope = abs(b) < 1e-20 ? 1e-20 : b;
    float t0 = -a / slope, t1 = (1.0 - a) / slope;
    return Span(min(t0, t1), max(t0, t1));
}

// Where the ray lies below an altitude: one stretch, since a sphere is convex.
Span span_below(AirRay ray, float altitude) {
    if (ray.altitude <= altitude) return Span(0.0, distance_out_of(ray, altitude));
    bool reaches = ray.along < 0.0 && closest_altitude(ray) < altitude;
    return reaches ? Span(distance_into(ray, altitude), distance_out_of(ray, altitude)) : Span(0.0, -1.0);
}

// The stretch of `ray` that meshes can shade. The ray starts `entry` [m] from the camera; `light` is its direction in the sun's frame.
Span shaded_span(AirRay ray, vec3 light, float entry, float end) {
    Cascade last = frame.cascades[MOST_CASCADES - 1];
    vec2 slope = light.xy * last.scale;
    vec2 start = last.offset + slope * entry;
    Span span = crossed(unit_span(start.x, slope.x), unit_span(start.y, slope.y));
    span = crossed(span, span_below(ray, frame.shadow_ceiling));
    return crossed(span, Span(0.0, end));
}

// What changes slowly along a ray, as the tables hold it: their 32nd roots follow an exponential nearly linearly, so that one
// look into the tables serves a few samples.
struct AirNode {
    float t;        // from the ray's origin [m]
    float altitude; // [m]
    vec3 sun_root;  // of the optical depth towards the sun
    vec3 psi_root;  // of the multiple scattering
};

const int NODE_SPACING = 4; // samples

AirNode air_node(Atmosphere atmosphere, AirRay ray, float t) {
    float altitude = altitude_at(ray, t), sun_along = ray.sun_along + t * ray.nu;
    vec2 sun_uv = transmittance_uv_from_altitude_along(atmosphere, altitude, sun_along);
    vec2 psi_uv = multiple_scattering_uv(atmosphere, altitude, sun_along / (atmosphere.ground_radius + altitude));
    return AirNode(t, altitude, sample_bilinear(transmittance_table, sun_uv).rgb, sample_bilinear(multiple_scattering_table, psi_uv).rgb);
}

// Adds the light of one cell, evaluated at distance t [m] between two nodes, and seen by the share `visibility` of the sun.
void add_air_cell(inout AirLight light, Atmosphere atmosphere, RayPhases phases, AirRay ray, AirNode near, AirNode far, float t,
                  float visibility, float cell_length) {
    float altitude = altitude_at(ray, t), sun_along = ray.sun_along + t * ray.nu;
    float share = clamp((t - near.t) / max(far.t - near.t, TINY), 0.0, 1.0);
    // Altitude bends between the nodes where a straight line of their depths would not: to first order of the root.
    float bend = (mix(near.altitude, far.altitude, share) - altitude) / (32.0 * atmosphere.scale_height);
    vec3 sun_depth = power32(mix(near.sun_root, far.sun_root, share) * (1.0 + bend));
    vec3 sun = exp(-sun_depth) * (sun_above_horizon_along(atmosphere, altitude, sun_along) * visibility);
    vec3 psi = power32(mix(near.psi_root, far.psi_root, share)) * ((frame.flags & FRAME_MULTIPLE_SCATTERING) != 0 ? 1.0 : 0.0);
    Medium medium = medium_at(atmosphere, altitude);
    add_cell(light, inscattering_source(medium, phases, sun, psi), medium.extinction, cell_length);
}

// `n` even cells, each looking into the cascades.
AirLight march_shaded(Atmosphere atmosphere, AirRay ray, RayPhases phases, vec3 light, float entry, Span span, int n, float dither) {
    AirLight result = no_air_light();
    float cell = (span.end - span.begin) / float(max(n, 1));
    AirNode near = air_node(atmosphere, ray, span.begin);
    for (int first = 0; first < n; first += NODE_SPACING) {
        int next = min(first + NODE_SPACING, n);
        AirNode far = air_node(atmosphere, ray, span.begin + float(next) * cell);
        for (int i = first; i < next; ++i) {
            float t = span.begin + (float(i) + dither) * cell;
            add_air_cell(result, atmosphere, phases, ray, near, far, t, air_visibility(light * (t + entry)), cell);
        }
        near = far;
    }
    return result;
}

// `n` cells placed by altitude, with nothing in the sun's way but the planet; added behind `result`.
void march_clear(inout AirLight result, Atmosphere atmosphere, AirRay ray, RayPhases phases, MarchCells cells, int n) {
    AirNode near = air_node(atmosphere, ray, cells.begin);
    float from = cells.begin;
    for (int first = 0; first < n; first += NODE_SPACING) {
        int next = min(first + NODE_SPACING, n);
        AirNode far = air_node(atmosphere, ray, march_distance(cells, float(next) / float(n)));
        for (int i = first; i < next; ++i) {
            MarchCell cell = march_cell_from(cells, from, i, n);
            from = cell.end;
            add_air_cell(result, atmosphere, phases, ray, near, far, cell.middle, 1.0, cell.end - cell.begin);
        }
        near = far;
    }
}

// `before` cells over one stretch, `behind` over another, with `between` in their middle. A loop of two, so that the march stands
// in the shader once.
AirLight march_around(Atmosphere atmosphere, AirRay ray, RayPhases phases, MarchCells first, int before, AirLight between,
                      MarchCells second, int behind) {
    AirLight result = no_air_light();
    for (int stretch = 0; stretch < 2; ++stretch) {
        if (stretch == 1) {
            result.inscattered += result.transmittance * between.inscattered;
            result.transmittance *= between.transmittance;
        }
        MarchCells cells = first;
        if (stretch == 1) cells = second;
        march_clear(result, atmosphere, ray, phases, cells, stretch == 0 ? before : behind);
    }
    return result;
}

// Cells for the stretch before, out of `n` for both, by their measure; at least one for each that is not empty.
int cells_before(MarchCells first, MarchCells second, int n) {
    float measure_first = first.measure_end - first.measure_begin, measure_second = second.measure_end - second.measure_begin;
    int share = int(round(float(n) * measure_first / max(measure_first + measure_second, TINY)));
    return clamp(share, first.end > first.begin ? 1 : 0, second.end > second.begin ? n - 1 : n);
}

// The segment's transmittance: from the table where that is well conditioned, from the march's own sum elsewhere.
vec3 segment_transmittance(AirRay ray, float end, vec3 marched) {
    SegmentTransmittance table = sample_segment_transmittance(transmittance_table, frame.atmosphere, air_point_at(ray, 0.0), air_point_at(ray, end));
    return mix(marched, table.transmittance, table.trust);
}

// `distance` [m] to the surface, negative for the sky. Everything relative to the sun's irradiance above the air.
AirLight march_air(ivec2 pixel, AirRay from_camera, vec3 light, float distance) {
    Atmosphere atmosphere = frame.atmosphere; // read once, before the loops
    float entry;
    AirRay ray = enter_air(frame.atmosphere, from_camera, entry);
    AirSegment air = air_segment(frame.atmosphere, ray);
    float end = distance < 0.0 ? air.end : min(distance - entry, distance_out_of(ray, frame.atmosphere.top_altitude));
    if (end <= 0.0 || (entry > 0.0 && closest_altitude(from_camera) >= frame.atmosphere.top_altitude)) return no_air_light();

    RayPhases phases = phases_of(frame.atmosphere, ray.nu);
    Span shaded = Span(0.0, 0.0);
    if ((frame.flags & FRAME_SHAFTS) != 0) shaded = shaded_span(ray, light, entry, end);
    int inside = 0, rest = frame.samples;
    if (shaded.end > shaded.begin) {
        bool whole = shaded.end - shaded.begin > 0.98 * end;
        if (whole) shaded = Span(0.0, end);
        inside = whole ? frame.samples : (frame.samples + 1) / 2;
        rest = frame.samples - inside;
    } else {
        shaded = Span(end, end);
    }
    float dither = 0.5;
    if ((frame.flags & FRAME_MARCH_DITHER) != 0) dither = gradient_noise(vec2(pixel) + 5.588238 * float(frame.sample_index));
    AirLight between = march_shaded(atmosphere, ray, phases, light, entry, shaded, inside, dither);

    MarchCells first = make_march_cells(atmosphere, ray, 0.0, shaded.begin), second = make_march_cells(atmosphere, ray, shaded.end, end);
    int before = rest > 0 ? cells_before(first, second, rest) : 0;
    AirLight result = march_around(atmosphere, ray, phases, first, before, between, second, rest - before);
    result.transmittance = segment_transmittance(ray, end, result.transmittance);
    return result;
}

#endif
