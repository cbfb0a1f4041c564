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

// Adds the light of one cell, evaluated at distance t [m] and seen by the share `visibility` of the sun.
void add_air_cell(inout AirLight light, Atmosphere atmosphere, RayPhases phases, AirRay ray, float t, float visibility, float cell_length) {
    float altitude = altitude_at(ray, t), sun_along = ray.sun_along + t * ray.nu;
    Medium medium = medium_at(atmosphere, altitude);
    vec3 sun = sample_sun_transmittance_along(transmittance_table, atmosphere, altitude, sun_along) * visibility;
    vec3 psi = vec3(0.0);
    if ((frame.flags & FRAME_MULTIPLE_SCATTERING) != 0) {
        float mu_s = sun_along / (atmosphere.ground_radius + altitude);
        psi = sample_multiple_scattering(multiple_scattering_table, atmosphere, altitude, mu_s);
    }
    add_cell(light, inscattering_source(medium, phases, sun, psi), medium.extinction, cell_length);
}

// `n` even cells, each looking into the cascades.
AirLight march_shaded(Atmosphere atmosphere, AirRay ray, RayPhases phases, vec3 light, float entry, Span span, int n, float dither) {
    AirLight result = no_air_light();
    float cell = (span.end - span.begin) / float(max(n, 1));
    for (int i = 0; i < n; ++i) {
        float t = span.begin + (float(i) + dither) * cell;
        float visibility = air_visibility(light * (t + entry));
        add_air_cell(result, atmosphere, phases, ray, t, visibility, cell);
    }
    return result;
}

// `before` cells over one stretch, `behind` over another, with `between` in their middle. One loop, so that both stretches cost one.
AirLight march_around(Atmosphere atmosphere, AirRay ray, RayPhases phases, Span first, int before, AirLight between, Span second, int behind) {
    AirLight result = no_air_light();
    MarchCells cells_before = make_march_cells(frame.atmosphere, ray, first.begin, max(first.end, first.begin));
    MarchCells cells_behind = make_march_cells(frame.atmosphere, ray, second.begin, max(second.end, second.begin));
    MarchCells cells = cells_before;
    int count = before, index = 0;
    float from = first.begin;
    for (int i = 0; i < before + behind; ++i, ++index) {
        if (i == before) {
            from = second.begin;
            result.inscattered += result.transmittance * between.inscattered;
            result.transmittance *= between.transmittance;
            cells = cells_behind;
            count = behind;
            index = 0;
        }
        MarchCell cell = march_cell_from(cells, from, index, count);
        from = cell.end;
        add_air_cell(result, atmosphere, phases, ray, cell.middle, 1.0, cell.end - cell.begin);
    }
    if (behind == 0) {
        result.inscattered += result.transmittance * between.inscattered;
        result.transmittance *= between.transmittance;
    }
    return result;
}

// Cells for the stretch before, out of `n` for both, by their measure; at least one for each that is not empty.
int cells_before(AirRay ray, Span first, Span second, int n) {
    MarchCells a = make_march_cells(frame.atmosphere, ray, first.begin, max(first.end, first.begin));
    MarchCells b = make_march_cells(frame.atmosphere, ray, second.begin, max(second.end, second.begin));
    float measure_a = a.measure_end - a.measure_begin, measure_b = b.measure_end - b.measure_begin;
    int share = int(round(float(n) * measure_a / max(measure_a + measure_b, TINY)));
    bool has_a = first.end > first.begin, has_b = second.end > second.begin;
    return clamp(share, has_a ? 1 : 0, has_b ? n - 1 : n);
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

    Span first = Span(0.0, shaded.begin), second = Span(shaded.end, end);
    int before = rest > 0 ? cells_before(ray, first, second, rest) : 0;
    AirLight result = march_around(atmosphere, ray, phases, first, before, between, second, rest - before);
    result.transmittance = segment_transmittance(ray, end, result.transmittance);
    return result;
}

#endif
