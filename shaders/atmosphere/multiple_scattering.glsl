// Light scattered more than once, from a table by altitude and sun: Hillaire 2020, as Sakmary tells it in 2.6.
// Every order from the second on is taken as isotropic, and the light around a point as the light at the point; then
// the orders are a geometric series. Psi is the mean radiance over all directions [1/sr per unit of solar irradiance
// above the air]: the source of orders >= 2 is (Rayleigh scattering + aerosol scattering) · Psi · solar irradiance.
// Table: MULTIPLE_SCATTERING_WIDTH x MULTIPLE_SCATTERING_HEIGHT, rgb = 32nd root of Psi; between two nodes of twilight Psi falls by powers of ten.
#ifndef ALPENGLOW_ATMOSPHERE_MULTIPLE_SCATTERING_GLSL
#define ALPENGLOW_ATMOSPHERE_MULTIPLE_SCATTERING_GLSL
#include "atmosphere/phase.glsl"
#include "atmosphere/segment_integral.glsl"
#include "atmosphere/sun_mapping.glsl"
#include "atmosphere/transmittance.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT int MULTIPLE_SCATTERING_DIRECTIONS = 64;
CONSTANT int MULTIPLE_SCATTERING_CELLS = 20;

// Direction i of n, spread evenly over the sphere along a spiral (Sakmary's Eq. 4.1 with its angles set right):
// z up, x towards the sun's azimuth.
INLINE vec3 spiral_direction(int i, int n) {
    float z = 1.0f - (2.0f * float(i) + 1.0f) / float(n);
    float side = sqrt(max(1.0f - z * z, 0.0f));
    float azimuth = GOLDEN_ANGLE * float(i);
    return vec3(side * cos(azimuth), side * sin(azimuth), z);
}

// Radiance that sunlit ground sends to the air above, per unit of solar irradiance [1/sr]. The sky's share is left out.
INLINE vec3 sunlit_ground(sampler2D transmittance_table, Atmosphere atmosphere, float mu_s) {
    return atmosphere.ground_albedo * sample_sun_transmittance(transmittance_table, atmosphere, 0.0f, mu_s) *
           (max(mu_s, 0.0f) / PI);
}

// One direction's share of the sums: light of the first order and from the ground, and light of a unit of radiance
// around.
struct OrderTransfer {
    vec3 first;  // [1/sr per unit of solar irradiance]
    vec3 around; // 0 to 1
};

INLINE OrderTransfer gather_orders(Atmosphere atmosphere, sampler2D transmittance_table, AirRay ray) {
    AirSegment segment = air_segment(atmosphere, ray);
    MarchCells cells = make_march_cells(atmosphere, ray, segment.begin, segment.end);
    OrderTransfer sum = OrderTransfer(vec3(0.0f), vec3(0.0f));
    vec3 transmittance = vec3(1.0f);
    float from = segment.begin;
    for (int i = 0; i < MULTIPLE_SCATTERING_CELLS; ++i) {
        MarchCell cell = march_cell_from(cells, from, i, MULTIPLE_SCATTERING_CELLS);
        from = cell.end;
        AirPoint point = air_point_at(ray, cell.middle);
        Medium medium = medium_at(atmosphere, point.altitude);
        float cell_length = cell.end - cell.begin;
        vec3 seen = transmittance * integrate_segment(total_scattering(medium), medium.extinction, cell_length);
        vec3 sun = sample_sun_transmittance(transmittance_table, atmosphere, point.altitude, point.mu_s);
        sum.first += seen * sun * ISOTROPIC_PHASE;
        sum.around += seen;
        transmittance *= exp(-medium.extinction * cell_length);
    }
    AirPoint last = air_point_at(ray, segment.end);
    vec3 ground = sunlit_ground(transmittance_table, atmosphere, last.mu_s);
    sum.first += transmittance * ground * vec3(segment.hits_ground ? 1.0f : 0.0f);
    return sum;
}

// Psi at altitude h [m] under a sun at mu_s, by integration.
INLINE vec3 compute_multiple_scattering(Atmosphere atmosphere, sampler2D transmittance_table, float h, float mu_s) {
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 0.0f));
    vec3 second = vec3(0.0f);
    vec3 again = vec3(0.0f);
    for (int i = 0; i < MULTIPLE_SCATTERING_DIRECTIONS; ++i) {
        vec3 direction = spiral_direction(i, MULTIPLE_SCATTERING_DIRECTIONS);
        float nu = clamp(direction.z * mu_s + direction.x * sin_sun, -1.0f, 1.0f);
        AirRay ray = make_air_ray(atmosphere.ground_radius, h, direction.z, mu_s, nu);
        OrderTransfer transfer = gather_orders(atmosphere, transmittance_table, ray);
        second += transfer.first;
        again += transfer.around;
    }
    vec3 share = vec3(1.0f / float(MULTIPLE_SCATTERING_DIRECTIONS));
    return second * share / max(vec3(1.0f) - again * share, vec3(1e-3f));
}

// The texel that stores Psi, and Psi from the table.
INLINE vec4 multiple_scattering_texel(vec3 psi) { return vec4(root32(psi), 1.0f); }

INLINE vec2 multiple_scattering_uv(Atmosphere atmosphere, float h, float mu_s) {
    return sun_table_uv(atmosphere, h, mu_s, MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT);
}

INLINE vec3 sample_multiple_scattering(sampler2D table, Atmosphere atmosphere, float h, float mu_s) {
    return power32(vec3(sample_bilinear(table, multiple_scattering_uv(atmosphere, h, mu_s))));
}

SHADER_NAMESPACE_END
#endif
