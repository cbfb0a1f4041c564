// All orders of scattering, as the moments of the light around each node of a table by altitude and sun
// (light_moments.glsl). The table is the fixed point of light <- first order + gather(what this light scatters): each
// round carries the light one order further. Everything is per unit of solar irradiance above the air.
// The share f of a phase's light goes straight on as if it weren't scattered: the extinction is less by f times the
// scattering (delta scaling: Joseph, Wiscombe and Weinman 1976).
#ifndef ALPENGLOW_ATMOSPHERE_MULTIPLE_SCATTERING_GLSL
#define ALPENGLOW_ATMOSPHERE_MULTIPLE_SCATTERING_GLSL
#include "atmosphere/diffuse_run.glsl"
#include "atmosphere/phase.glsl"
#include "atmosphere/segment_integral.glsl"
#include "atmosphere/sunlight.glsl"
SHADER_NAMESPACE_BEGIN

// Directions in which a node looks: panels of four zeniths above the horizon and below it, azimuths over half a turn.
struct GatherRays {
    int above;
    int below;
    int azimuths;
    int cells; // of the march
};

CONSTANT GatherRays FIRST_ORDER_RAYS = GatherRays(4, 2, 12, 24);
CONSTANT GatherRays HIGHER_ORDER_RAYS = GatherRays(3, 2, 6, 16);

INLINE int gather_count(GatherRays rays) { return 4 * (rays.above + rays.below) * rays.azimuths; }

struct GatherDirection {
    float mu;
    SunwardDirection sunward;
    float weight; // share of all directions
};

// Direction i. Zeniths are nodes of Gauss and Legendre in the cube root of the distance to the horizon, where the light
// changes fastest: from 30 km it has a limb of a degree.
INLINE GatherDirection gather_direction(IN(Atmosphere) atmosphere, GatherRays rays, float h, float mu_s, int i) {
    int zenith = i / rays.azimuths;
    bool above = zenith < 4 * rays.above;
    int panels = above ? rays.above : rays.below;
    int place = above ? zenith : zenith - 4 * rays.above;
    bool outer = place % 4 == 0 || place % 4 == 3;
    float offset = outer ? 0.861136312f : 0.339981044f;
    float u = (float(place / 4) + 0.5f + (place % 4 < 2 ? -0.5f : 0.5f) * offset) / float(panels);
    float share = (outer ? 0.173927423f : 0.326072577f) / float(panels);
    float horizon = horizon_mu(atmosphere.ground_radius, h);
    float reach = above ? 1.0f - horizon : -1.0f - horizon;
    float mu = clamp(horizon + reach * u * u * u, -1.0f, 1.0f);
    float azimuth = PI * (float(i % rays.azimuths) + 0.5f) / float(rays.azimuths);
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 0.0f));
    float level = sqrt(max(1.0f - mu * mu, 0.0f)) * cos(azimuth);
    SunwardDirection sunward =
        SunwardDirection(clamp(mu * mu_s + level * sin_sun, -1.0f, 1.0f), mu * sin_sun - level * mu_s);
    return GatherDirection(mu, sunward, 1.5f * abs(reach) * u * u * share / float(rays.azimuths));
}

// What a node's moments count of light from there: the B_i and the sixteenth.
INLINE Moments gather_basis(GatherDirection direction) {
    Moments basis = moment_basis(direction.sunward);
    basis.part[1].w = zonal4(direction.mu);
    return basis;
}

// Extinction [1/m] of light that has been scattered.
INLINE vec3 diffuse_extinction(IN(Atmosphere) atmosphere, IN(Medium) medium) {
    vec3 extinction = medium.extinction;
    for (int i = 0; i < AIR_COMPONENTS; ++i)
        if (component_scatters(atmosphere, i))
            extinction -= medium.scattering[i] * (1.0f - AIR_CONTENT(atmosphere).components[i].moments.degree[0]);
    return extinction;
}

// Radiance that the ground sends up [1/sr], under an irradiance.
INLINE vec3 ground_radiance(IN(Atmosphere) atmosphere, vec3 irradiance) { return atmosphere.ground_albedo * irradiance / PI; }

// A cell of a march with its air.
struct AirCell {
    MarchCell place;
    CellMedium air;
    float size;   // [m]
    float centre; // where it stands for itself: distance from the ray's origin [m]
};

// The i-th of n cells; `from` is where it begins [m] and `edge` the medium there, and then where it ends.
INLINE AirCell next_air_cell(IN(Atmosphere) atmosphere, AirRay ray, IN(MarchCells) cells, INOUT(float) from,
                             INOUT(Medium) edge, int i, int n) {
    AirCell cell;
    cell.place = march_cell_from(cells, from, i, n);
    Medium next = medium_at(atmosphere, altitude_at(ray, cell.place.end));
    cell.air = cell_medium(edge, medium_at(atmosphere, altitude_at(ray, cell.place.middle)), next);
    cell.size = cell.place.end - from;
    cell.centre = cell.place.middle + cell.air.centre * cell.size;
    from = cell.place.end;
    edge = next;
    return cell;
}

// Radiance of the first order that a ray inside the air brings to its origin [1/sr]: sunlight that the air or the ground
// has scattered once.
INLINE vec3 first_order_light(IN(Atmosphere) atmosphere, sampler2D sunlight_table, AirRay ray, int n) {
    AirSegment segment = air_segment(atmosphere, ray);
    MarchCells cells = make_march_cells(atmosphere, ray, segment.begin, segment.end);
    RayPhases phases = phases_of(atmosphere, ray.nu);
    AirLight light = no_air_light();
    float from = segment.begin;
    Medium edge = medium_at(atmosphere, altitude_at(ray, from));
    int i = 0;
    do {
        AirCell cell = next_air_cell(atmosphere, ray, cells, from, edge, i, n);
        AirPoint point = air_point_at(ray, cell.centre);
        vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, point.altitude, point.mu_s);
        vec3 source = directed_scattering(cell.air.mean, phases) * sun;
        add_cell(light, source, diffuse_extinction(atmosphere, cell.air.mean), cell.size);
    } while (++i < n);
    AirPoint last = air_point_at(ray, segment.end);
    vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, 0.0f, last.mu_s) * max(last.mu_s, 0.0f);
    vec3 ground = ground_radiance(atmosphere, sun);
    return behind_air(light, ground * vec3(segment.hits_ground ? 1.0f : 0.0f));
}

// Radiance that a ray inside the air brings to its origin [1/sr], of the light in the table scattered once more.
INLINE vec3 scattered_light(IN(Atmosphere) atmosphere, sampler2D table, AirRay ray, int n) {
    AirSegment segment = air_segment(atmosphere, ray);
    MarchCells cells = make_march_cells(atmosphere, ray, segment.begin, segment.end);
    AirLight light = no_air_light();
    float from = segment.begin;
    Medium edge = medium_at(atmosphere, altitude_at(ray, from));
    DiffuseRun run;
    run.far = diffuse_node(table, atmosphere, ray, from);
    int i = 0;
    do {
        int first = i, end = min(first + RUN, n);
        float per_cell = 1.0f / float(end - first);
        run.near = run.far;
        run.middle = diffuse_node(table, atmosphere, ray, march_distance(cells, 0.5f * float(first + end) / float(n)));
        run.far = diffuse_node(table, atmosphere, ray, march_distance(cells, float(end) / float(n)));
        do {
            AirCell cell = next_air_cell(atmosphere, ray, cells, from, edge, i, n);
            DiffuseLight diffuse =
                diffuse_light_in(atmosphere, run, (float(i - first) + 0.5f + cell.air.centre) * per_cell);
            vec3 source = diffuse_source(cell.air.mean, diffuse);
            add_cell(light, source, diffuse_extinction(atmosphere, cell.air.mean), cell.size);
        } while (++i < end);
    } while (i < n);
    float mu_s = air_point_at(ray, segment.end).mu_s;
    vec3 irradiance = sample_diffuse_irradiance(table, atmosphere, 0.0f, mu_s, 1.0f, mu_s);
    return behind_air(light, ground_radiance(atmosphere, irradiance) * vec3(segment.hits_ground ? 1.0f : 0.0f));
}

// Moments of one channel, not divided by m_0, as the table's tiles hold them; and back.
INLINE Moments packed_moments(Moments sum) {
    float mean = max(sum.part[0].x, 1e-36f);
    Moments texels = scaled(sum, 1.0f / mean);
    texels.part[0].x = root32(vec3(mean)).x;
    return texels;
}

INLINE Moments unpacked_moments(Moments texels) {
    float mean = power32(vec3(texels.part[0].x)).x;
    texels.part[0].x = 1.0f;
    return scaled(texels, mean);
}

// The sum of all orders from three sums, each an order longer, where each order is worth the same share of the last. At
// most 0.95: a share measured on the last digits of a table that has converged means nothing, and harms nothing.
INLINE Moments extrapolated_moments(Moments oldest, Moments older, Moments newest) {
    float order = newest.part[0].x - older.part[0].x;
    float share = clamp(order / max(older.part[0].x - oldest.part[0].x, 1e-36f), 0.0f, 0.95f);
    float tail = share / (1.0f - share);
    return sum_of(newest, scaled(sum_of(newest, scaled(older, -1.0f)), tail));
}

SHADER_NAMESPACE_END
#endif
