// Light scattered more than once, as the model `tables` has it: Hillaire 2020, as Sakmary tells it in 2.6.
// Every order from the second on is taken as isotropic, and the light around a point as the light at the point; then
// the orders are a geometric series. Psi is the mean radiance over all directions [1/sr per unit of solar irradiance
// above the air]. Table: ISOTROPIC_SIZE squared, rgb = 32nd root of Psi; between two nodes of twilight Psi falls by
// powers of ten.
#ifndef ALPENGLOW_MODELS_TABLES_ISOTROPIC_GLSL
#define ALPENGLOW_MODELS_TABLES_ISOTROPIC_GLSL
#include "atmosphere/inscattering.glsl"
#include "atmosphere/sun_mapping.glsl"
#include "interop/models/tables.h"
SHADER_NAMESPACE_BEGIN

CONSTANT int ISOTROPIC_DIRECTIONS = 64;
CONSTANT int ISOTROPIC_CELLS = 20;

// Direction i of n, spread evenly over the sphere along a spiral (Sakmary's Eq. 4.1 with its angles set right):
// z up, x towards the sun's azimuth.
INLINE vec3 even_direction(int i, int n) {
    float z = 1.0f - (2.0f * float(i) + 1.0f) / float(n);
    float side = sqrt(max(1.0f - z * z, 0.0f));
    float azimuth = GOLDEN_ANGLE * float(i);
    return vec3(side * cos(azimuth), side * sin(azimuth), z);
}

// Radiance per metre [1/(sr m)] that the medium adds to a ray: sunlight `sun` by the phases, further orders evenly.
INLINE vec3 isotropic_source(Medium medium, RayPhases phases, vec3 sun, vec3 psi) {
    return inscattering_source(medium, phases, sun, no_diffuse_light()) + total_scattering(medium) * psi;
}

// One direction's share of the sums.
struct IsotropicTransfer {
    vec3 first;  // light of the first order and from the sunlit ground [1/sr per unit of solar irradiance]
    vec3 around; // what a unit of radiance all around sends: 0 to 1
};

INLINE IsotropicTransfer gather_isotropic(IN(Atmosphere) atmosphere, sampler2D sunlight_table, AirRay ray) {
    AirSegment segment = air_segment(atmosphere, ray);
    MarchCells cells = make_march_cells(atmosphere, ray, segment.begin, segment.end);
    IsotropicTransfer sum = IsotropicTransfer(vec3(0.0f), vec3(0.0f));
    vec3 transmittance = vec3(1.0f);
    float from = segment.begin;
    for (int i = 0; i < ISOTROPIC_CELLS; ++i) {
        MarchCell cell = march_cell_from(cells, from, i, ISOTROPIC_CELLS);
        from = cell.end;
        AirPoint point = air_point_at(ray, cell.middle);
        Medium medium = medium_at(atmosphere, point.altitude);
        float cell_length = cell.end - cell.begin;
        vec3 seen = transmittance * integrate_segment(total_scattering(medium), medium.extinction, cell_length);
        vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, point.altitude, point.mu_s);
        sum.first += seen * sun * ISOTROPIC_PHASE;
        sum.around += seen;
        transmittance *= exp(-medium.extinction * cell_length);
    }
    AirPoint last = air_point_at(ray, segment.end);
    vec3 sunlit = sample_sun_transmittance(sunlight_table, atmosphere, 0.0f, last.mu_s) * (max(last.mu_s, 0.0f) / PI);
    sum.first += transmittance * atmosphere.ground_albedo * sunlit * vec3(segment.hits_ground ? 1.0f : 0.0f);
    return sum;
}

// Psi at altitude h [m] under a sun at mu_s, by integration.
INLINE vec3 compute_isotropic(IN(Atmosphere) atmosphere, sampler2D sunlight_table, float h, float mu_s) {
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 0.0f));
    vec3 second = vec3(0.0f);
    vec3 again = vec3(0.0f);
    for (int i = 0; i < ISOTROPIC_DIRECTIONS; ++i) {
        vec3 direction = even_direction(i, ISOTROPIC_DIRECTIONS);
        float nu = clamp(direction.z * mu_s + direction.x * sin_sun, -1.0f, 1.0f);
        AirRay ray = make_air_ray(atmosphere.ground_radius, h, direction.z, mu_s, nu);
        IsotropicTransfer transfer = gather_isotropic(atmosphere, sunlight_table, ray);
        second += transfer.first;
        again += transfer.around;
    }
    vec3 share = vec3(1.0f / float(ISOTROPIC_DIRECTIONS));
    return second * share / max(vec3(1.0f) - again * share, vec3(1e-3f));
}

INLINE vec3 sample_isotropic(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s) {
    vec2 uv = sun_table_uv(atmosphere, h, mu_s, ISOTROPIC_SIZE, ISOTROPIC_SIZE);
    return power32(vec3(sample_bilinear(table, uv)));
}

// Adds the light of one cell, with source and extinction as at distance t [m].
INLINE void add_isotropic_cell(INOUT(AirLight) light, IN(Atmosphere) atmosphere, sampler2D sunlight_table,
                               sampler2D isotropic_table, RayPhases phases, AirRay ray, float t, float cell_length) {
    AirPoint point = air_point_at(ray, t);
    float h = max(point.altitude, 0.0f);
    Medium medium = medium_at(atmosphere, h);
    vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, h, point.mu_s);
    vec3 psi = sample_isotropic(isotropic_table, atmosphere, h, point.mu_s);
    add_cell(light, isotropic_source(medium, phases, sun, psi), medium.extinction, cell_length);
}

SHADER_NAMESPACE_END
#endif
