// Light of ground that is not the planet's mean, in the air above it. The table of all orders (multiple_scattering.glsl) is made over
// ground of the planet's mean albedo; what ground differs by is light of its own, even all around and as bright in all
// directions, and air answers it in proportion: the response, the moments of the light over black ground whose radiance
// is 1. They are the same on all sides of the zenith and depend on the altitude alone.
// Table: as light_moments.glsl has it, one node wide, with the zenith in place of the sun: what changes with the azimuth is 0.
#ifndef ALPENGLOW_ATMOSPHERE_GROUND_RESPONSE_GLSL
#define ALPENGLOW_ATMOSPHERE_GROUND_RESPONSE_GLSL
#include "atmosphere/multiple_scattering.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT GatherRays GROUND_RESPONSE_RAYS = GatherRays(3, 2, 1, 16);

// Altitude [m] of a row of the table.
INLINE float ground_response_altitude(IN(Atmosphere) atmosphere, int row) {
    float v = (float(row) + 0.5f) / float(MULTIPLE_SCATTERING_HEIGHT);
    return altitude_sun_from_uv(atmosphere, vec2(1.0f, v), MULTIPLE_SCATTERING_WIDTH, MULTIPLE_SCATTERING_HEIGHT).x;
}

// Radiance that a ray inside the air brings to its origin: the ground's, and, unless it is the `first` round, that of the
// table scattered once more.
INLINE vec3 light_over_bright_ground(IN(Atmosphere) atmosphere, sampler2D response, AirRay ray, int n, bool first) {
    AirSegment segment = air_segment(atmosphere, ray);
    MarchCells cells = make_march_cells(atmosphere, ray, segment.begin, segment.end);
    AirLight light = no_air_light();
    float from = segment.begin;
    Medium edge = medium_at(atmosphere, altitude_at(ray, from));
    int i = 0;
    do {
        AirCell cell = next_air_cell(atmosphere, ray, cells, from, edge, i, n);
        AirPoint point = air_point_at(ray, cell.centre);
        AirPoint under_zenith = AirPoint(point.altitude, point.mu, 1.0f);
        DiffuseLight diffuse = sample_diffuse_light(response, atmosphere, under_zenith, point.mu);
        if (first) diffuse = no_diffuse_light();
        add_cell(light, diffuse_source(cell.air.mean, diffuse), diffuse_extinction(atmosphere, cell.air.mean), cell.size);
    } while (++i < n);
    return behind_air(light, vec3(segment.hits_ground ? 1.0f : 0.0f));
}

// The part that is the same on all sides of the polar axis: a sum over directions of one azimuth has no other.
INLINE Moments zonal_moments(Moments sum) {
    Moments zonal = no_moments();
    zonal.part[0] = vec4(sum.part[0].x, sum.part[0].y, 0.0f, sum.part[0].w);
    zonal.part[1] = vec4(sum.part[1].x, 0.0f, 0.0f, sum.part[1].w);
    zonal.part[2].x = sum.part[2].x;
    return zonal;
}

// Moments around the sun of light that has these around the zenith: by the addition theorem each degree's is spread over
// the harmonics' values at the zenith.
INLINE Moments turned_to_sun(Moments zonal, float mu_s) {
    Moments turned = moment_basis(SunwardDirection(mu_s, sqrt(max(1.0f - mu_s * mu_s, 0.0f))));
    float first = zonal.part[0].y * 0.577350269f, second = zonal.part[1].x * 0.447213595f; // over the root of 2 l + 1
    float third = zonal.part[2].x * 0.377964473f, fourth = zonal.part[0].w / 3.0f;
    turned.part[0] *= vec4(zonal.part[0].x, first, first, fourth);
    turned.part[1] = vec4(turned.part[1].x * second, turned.part[1].y * second, turned.part[1].z * second, zonal.part[1].w);
    turned.part[2] *= third;
    turned.part[3] *= fourth;
    return turned;
}

// By how much ground of the table's model, which lies at altitude 0, has to be brighter [1/sr] under a sun at mu_s for the
// air above the ground that is there: at its altitude [m] the share `albedo` of what comes down goes up. `table`: of all
// orders. Not darker than black, so that no light is less than none in the air below that altitude.
INLINE vec3 ground_difference(IN(Atmosphere) atmosphere, sampler2D sunlight_table, sampler2D table, sampler2D response,
                              vec3 albedo, float altitude, float mu_s) {
    vec3 sun = sample_sun_transmittance(sunlight_table, atmosphere, altitude, mu_s);
    vec3 down = sun * max(mu_s, 0.0f) + sample_diffuse_irradiance(table, atmosphere, altitude, mu_s, 1.0f, mu_s);
    vec3 up = sample_diffuse_irradiance(table, atmosphere, altitude, mu_s, -1.0f, -mu_s);
    vec3 level_sun = sample_sun_transmittance(sunlight_table, atmosphere, 0.0f, mu_s) * max(mu_s, 0.0f);
    vec3 level = level_sun + sample_diffuse_irradiance(table, atmosphere, 0.0f, mu_s, 1.0f, mu_s);
    // Less what the table's own ground is off by, so that ground like it makes no difference.
    up -= sample_diffuse_irradiance(table, atmosphere, 0.0f, mu_s, -1.0f, -mu_s) - atmosphere.ground_albedo * level;
    vec3 response_down = sample_diffuse_irradiance(response, atmosphere, altitude, 1.0f, 1.0f, 1.0f);
    vec3 response_up = sample_diffuse_irradiance(response, atmosphere, altitude, 1.0f, -1.0f, -1.0f);
    vec3 difference = (albedo * down - up) / max(response_up - albedo * response_down, 1e-3f * response_up);
    return max(difference, -ground_radiance(atmosphere, level));
}

// Of one channel: all orders over the planet's ground, and the response times that difference.
INLINE Moments over_other_ground(Moments light, Moments response, float difference, float mu_s) {
    return sum_of(light, scaled(turned_to_sun(response, mu_s), difference));
}

SHADER_NAMESPACE_END
#endif
