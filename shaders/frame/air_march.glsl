// The march from the camera to the surface or out of the air, with the shadows that meshes throw into it.
// A ray is cut in three: before, inside and behind the span where the cascades say what is shaded. Inside it has half as many cells as
// there are samples, evenly, fewer where it is short; around it as many as there are samples, placed by altitude. Included by passes whose images it reads.
#ifndef ALPENGLOW_FRAME_AIR_MARCH
#define ALPENGLOW_FRAME_AIR_MARCH
#include "atmosphere/inscattering.glsl"
#include "encoding/color.glsl"
#include "frame/shafts.glsl"
#include "frame/terrain_air.glsl"

// Where the ray lies below an altitude: one stretch, since a sphere is convex.
Span span_below(AirRay ray, float altitude) {
    if (ray.altitude <= altitude) return Span(0.0, distance_out_of(ray, altitude));
    bool reaches = ray.along < 0.0 && closest_altitude(ray) < altitude;
    return reaches ? Span(distance_into(ray, altitude), distance_out_of(ray, altitude)) : Span(0.0, -1.0);
}

// The stretch of `ray` that meshes can shade. The ray starts `entry` [m] from the camera; `light` is its direction in the sun's frame.
Span shaded_span(AirRay ray, vec3 light, float entry, float end) {
    Span span = crossed(Span(0.0, end), span_below(ray, frame.shaded_altitude));
    for (int i = 0; i < 3; ++i) {
        float slope = dot(frame.shaded_slabs[i].xyz, light);
        span = crossed(span, unit_span(frame.shaded_slabs[i].w + slope * entry, slope));
    }
    return span;
}

// The share of a cell's light that is left where the sun is seen in parts of it: more, where it is seen in that with more air, or
// with less before it.
float seen_light(Seen seen, Medium begin, Medium mean, Medium end, float cell_length) {
    float rise = (total_scattering(end).y - total_scattering(begin).y) / max(total_scattering(mean).y, TINY);
    return clamp(seen.mean + clamp(rise - mean.extinction.y * cell_length, -2.0, 2.0) * seen.slope, 0.0, 1.0);
}

// Adds the light of one cell. `middle` is its share of the run, `shares` those of the sun's disc that no mesh hides; `edge` the
// medium where the cell begins, and then where it ends.
void add_air_cell(inout AirLight light, Atmosphere atmosphere, RayPhases phases, AirRay ray, MarchCell cell, DiffuseRun run,
                  float middle, float per_cell, Seen shares, inout Medium edge) {
    Medium next = medium_at(atmosphere, altitude_at(ray, cell.end));
    CellMedium air = cell_medium(edge, medium_at(atmosphere, altitude_at(ray, cell.middle)), next);
    float cell_length = cell.end - cell.begin, t = cell.middle + air.centre * cell_length;
    float seen = seen_light(shares, edge, air.mean, next, cell_length);
    edge = next;
    vec3 sun = seen * sample_sun_transmittance_along(sunlight_table, atmosphere, altitude_at(ray, t), ray.sun_along + t * ray.nu);
    DiffuseLight diffuse = shaded_light(atmosphere, phases, diffuse_light_in(atmosphere, run, middle + air.centre * per_cell), seen);
    vec3 extinction = diffuse_extinction(atmosphere, air.mean);
    if ((MARCH_VARIANT & MARCH_ONE_ORDER) != 0) {
        diffuse = no_diffuse_light();
        extinction = air.mean.extinction;
    }
    add_cell(light, inscattering_source(air.mean, phases, sun, diffuse), extinction, cell_length);
}

// Where meshes shade a ray that starts `entry` [m] from the camera, and where it goes. Spans and `shaft` are from the camera on.
struct Shade {
    ShaftRay shaft;
    vec3 direction; // world axes
    float entry;
    Span shaded; // empty: nowhere
    float dither;
};

// Diffuse light at a place of the ray: of the table as far as the map of the light on terrain knows no better.
DiffuseLight light_node(Atmosphere atmosphere, Shade shade, AirRay ray, float t) {
    DiffuseLight light = diffuse_node(multiple_scattering_table, atmosphere, ray, t);
    TerrainAir terrain = terrain_air(shade.direction * (t + shade.entry), shade.direction);
    light.root = mix(light.root, root32(terrain.mean), terrain.share);
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        if (component_scatters(atmosphere, i)) {
            PhaseMoments phase = AIR_CONTENT(atmosphere).components[i].moments;
            vec3 gain = max(vec3(phase.degree[0]) + phase.degree[1] * terrain.first, vec3(0.0));
            light.gain[i] = mix(light.gain[i], gain, terrain.share);
        }
    light.glow *= 1.0 - terrain.share;
    light.known = terrain.known;
    return light;
}

// The diffuse light of a run of cells from where `near` is known on: its middle and far end at two distances [m].
DiffuseRun run_from(DiffuseLight near, Atmosphere atmosphere, Shade shade, AirRay ray, float middle, float far) {
    return DiffuseRun(near, light_node(atmosphere, shade, ray, middle), light_node(atmosphere, shade, ray, far));
}

// The loops of the march turn as often for every ray of a subgroup, and test at their end; a ray that is through goes on with cells of
// no length. Software devices run the body of a loop that tests at its start once more than it turns, all of what is inside it too;
// and lavapipe (22.3) gives a ray that left a loop early the values of the last turn.

// Of the cells of `march_evenly`. Light changes slowly along a ray and shadows fast: each cell has several looks into the cascades.
Seen seen_in_even(Shade shade, float begin, float end, int number) {
    float near = begin + shade.entry, far = end + shade.entry;
    if ((MARCH_VARIANT & MARCH_EXACT) != 0) return Seen(seen_at_place(shade.shaft, near, far, shade.dither, number), 0.0);
    return seen_near(shade.shaft, near, far, number);
}

// Of the cells around them.
Seen seen_around(Shade shade, float begin, float end) {
    if ((MARCH_VARIANT & (MARCH_EXACT | MARCH_NO_SHAFTS)) != 0) return Seen(1.0, 0.0);
    return seen_beyond(shade.shaft, shade.shaded, begin + shade.entry, end + shade.entry, shade.dither);
}

// `n` even cells.
AirLight march_evenly(Atmosphere atmosphere, AirRay ray, RayPhases phases, Shade shade, Span span, int n) {
    AirLight result = no_air_light();
    float size = (span.end - span.begin) / float(max(n, 1));
    DiffuseLight near = light_node(atmosphere, shade, ray, span.begin);
    int i = 0;
    do {
        int first = i, next = min(first + RUN, n);
        float per_cell = 1.0 / float(max(next - first, 1)), from = span.begin + float(first) * size, to = span.begin + float(next) * size;
        DiffuseRun run = run_from(near, atmosphere, shade, ray, 0.5 * (from + to), to);
        Medium edge = medium_at(atmosphere, altitude_at(ray, from));
        do {
            float begin = span.begin + float(min(i, next)) * size, cell_size = i < next ? size : 0.0;
            MarchCell cell = MarchCell(begin, begin + 0.5 * cell_size, begin + cell_size);
            Seen seen = seen_in_even(shade, begin, begin + cell_size, i);
            add_air_cell(result, atmosphere, phases, ray, cell, run, (float(i - first) + 0.5) * per_cell, per_cell, seen, edge);
            ++i;
        } while (subgroupAny(i < next));
        i = next;
        near = run.far;
    } while (subgroupAny(i < n));
    return result;
}

// A stretch with cells placed by altitude.
struct Placed {
    MarchCells cells;
    int count;
};

// One stretch, then `between`, then another.
AirLight march_around(Atmosphere atmosphere, AirRay ray, RayPhases phases, Shade shade, Placed before, AirLight between, Placed behind) {
    AirLight result = no_air_light();
    Placed stretch = before;
    bool passed = before.count == 0; // what lies between
    if (passed) {
        result = between;
        stretch = behind;
    }
    DiffuseLight near = light_node(atmosphere, shade, ray, march_distance(stretch.cells, 0.0));
    int i = 0;
    bool leaps = false; // from the one to the other: a turn without cells
    do {
        int n = max(stretch.count, 1), first = i, next = leaps ? 0 : min(first + RUN, stretch.count);
        float per_cell = 1.0 / float(max(next - first, 1)), from = march_distance(stretch.cells, float(first) / float(n));
        DiffuseRun run = run_from(near, atmosphere, shade, ray, march_distance(stretch.cells, 0.5 * float(first + next) / float(n)),
                                  march_distance(stretch.cells, float(next) / float(n)));
        Medium edge = medium_at(atmosphere, altitude_at(ray, from));
        do {
            MarchCell cell = march_cell_from(stretch.cells, from, i, n);
            if (i >= next) cell = MarchCell(from, from, from);
            from = cell.end;
            Seen seen = seen_around(shade, cell.begin, cell.end);
            add_air_cell(result, atmosphere, phases, ray, cell, run, (float(i - first) + 0.5) * per_cell, per_cell, seen, edge);
            ++i;
        } while (subgroupAny(i < next));
        i = next;
        near = run.far;
        leaps = i >= stretch.count && !passed;
        if (leaps) {
            result.inscattered += result.transmittance * between.inscattered;
            result.transmittance *= between.transmittance;
            stretch = behind;
            passed = true;
            i = 0;
        }
    } while (subgroupAny(i < stretch.count));
    return result;
}

// Cells for the stretch before, out of `n` for both, by their measure; at least one for each that is not empty.
int cells_before(MarchCells first, MarchCells second, int n) {
    float measure_first = first.measure_end - first.measure_begin, measure_second = second.measure_end - second.measure_begin;
    int share = int(round(float(n) * measure_first / max(measure_first + measure_second, TINY)));
    return clamp(share, first.end > first.begin ? 1 : 0, second.end > second.begin ? n - 1 : n);
}

// Transmittance from the ray's origin out of the air, of light that is not scattered at all: the sun's disc is too narrow for what
// goes nearly straight on. From the table where that is well conditioned, from the march's own sum elsewhere.
vec3 celestial_transmittance(AirRay ray, float end, vec3 marched) {
    SegmentTransmittance table = sample_segment_transmittance(transmittance_table, frame.atmosphere, air_point_at(ray, 0.0), air_point_at(ray, end));
    return mix(marched, table.transmittance, table.trust);
}

const float FULL_DEPTH = 0.016; // tuned: the extinction along 500 m of clear air near the ground

// Cells for the stretch that the cascades shade: half as many as samples, and fewer where its optical depth is below FULL_DEPTH: no
// shadow shows in a few metres of air.
int shaded_samples(Atmosphere atmosphere, AirRay ray, Span shaded) {
    float lowest = min(altitude_at(ray, shaded.begin), altitude_at(ray, shaded.end));
    vec3 extinction = medium_at(atmosphere, lowest).extinction;
    float depth = max(extinction.x, max(extinction.y, extinction.z)) * (shaded.end - shaded.begin);
    return int(round(float((frame.samples + 1) / 2) * min(depth / FULL_DEPTH, 1.0)));
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
    bool shafts = (MARCH_VARIANT & MARCH_NO_SHAFTS) == 0, exact = (MARCH_VARIANT & MARCH_EXACT) != 0;
    Shade shade = Shade(make_shaft_ray(light), light * frame.light_from_world, entry, Span(0.0, 0.0), 0.5);
    if ((frame.flags & FRAME_MARCH_DITHER) != 0) shade.dither = gradient_noise(vec2(pixel) + 5.588238 * float(frame.sample_index));
    Span even = Span(0.0, 0.0);
    if (shafts) {
        even = shaded_span(ray, light, entry, end);
        shade.shaded = moved(even, entry);
        if (!exact) even = crossed(even, moved(shade.shaft.near, -entry));
    }
    int inside = 0, rest = frame.samples;
    if (even.end > even.begin) {
        bool whole = even.end - even.begin > 0.98 * end;
        if (whole) even = Span(0.0, end);
        inside = exact ? frame.exact_cells : whole ? (frame.samples + 1) / 2 : shaded_samples(atmosphere, ray, even);
        if (whole) rest = 0;
    }
    if (inside == 0) even = Span(end, end);
    AirLight between = no_air_light();
    if (shafts) between = march_evenly(atmosphere, ray, phases, shade, even, inside);

    MarchCells first = make_march_cells(atmosphere, ray, 0.0, even.begin), second = make_march_cells(atmosphere, ray, even.end, end);
    int before = rest > 0 ? cells_before(first, second, rest) : 0;
    AirLight result = march_around(atmosphere, ray, phases, shade, Placed(first, before), between, Placed(second, rest - before));
    if (distance < 0.0) result.transmittance = celestial_transmittance(ray, end, result.transmittance);
    return result;
}

#endif
