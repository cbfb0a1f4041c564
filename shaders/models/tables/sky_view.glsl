// What a camera inside the air sees in every direction, by azimuth from the sun and zenith angle, down to the planet where
// a ray meets it. Table: SKY_VIEW_WIDTH x SKY_VIEW_HEIGHT, rgb = in-scattered radiance per unit of solar irradiance.
// The mapping is that of Hillaire's code: x = sin(azimuth / 2); y runs from the zenith to the nadir, dense on both sides
// of the horizon in the middle.
#ifndef ALPENGLOW_MODELS_TABLES_SKY_VIEW_GLSL
#define ALPENGLOW_MODELS_TABLES_SKY_VIEW_GLSL
#include "models/tables/isotropic.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT int SKY_VIEW_CELLS = 30;        // as Sakmary has them, in squared spacing
CONSTANT float SKY_VIEW_SAMPLE = 0.3f;   // of a cell: where it is evaluated

struct SkyDirection {
    float mu;          // cosine with the zenith
    float cos_azimuth; // from the sun
};

// Angle between the nadir and the horizon [rad], from altitude h [m].
INLINE float nadir_to_horizon(IN(Atmosphere) atmosphere, float h) {
    return PI - acos(clamp(horizon_mu(atmosphere.ground_radius, max(h, 0.0f)), -1.0f, 1.0f));
}

INLINE vec2 sky_view_uv(IN(Atmosphere) atmosphere, float h, SkyDirection direction, bool hits_ground) {
    float below = nadir_to_horizon(atmosphere, h);
    float zenith = acos(clamp(direction.mu, -1.0f, 1.0f));
    float up = 0.5f - 0.5f * sqrt(clamp(1.0f - zenith / (PI - below), 0.0f, 1.0f));
    float down = 0.5f + 0.5f * sqrt(clamp((zenith - (PI - below)) / below, 0.0f, 1.0f));
    float x = sqrt(clamp(0.5f - 0.5f * direction.cos_azimuth, 0.0f, 1.0f));
    return vec2(uv_from_unit(x, SKY_VIEW_WIDTH), uv_from_unit(hits_ground ? down : up, SKY_VIEW_HEIGHT));
}

INLINE SkyDirection sky_direction_from_uv(IN(Atmosphere) atmosphere, float h, vec2 uv) {
    float below = nadir_to_horizon(atmosphere, h);
    float y = 2.0f * unit_from_uv(uv.y, SKY_VIEW_HEIGHT) - 1.0f;
    float zenith = PI - below + (y < 0.0f ? -y * y * (PI - below) : y * y * below);
    float x = clamp(unit_from_uv(uv.x, SKY_VIEW_WIDTH), 0.0f, 1.0f);
    return SkyDirection(cos(zenith), 1.0f - 2.0f * x * x);
}

// Light between the origin of a ray inside the air and a distance `end` [m].
INLINE AirLight march_squared(IN(Atmosphere) atmosphere, sampler2D sunlight_table, sampler2D isotropic_table, AirRay ray,
                              float end, int cells) {
    RayPhases phases = phases_of(atmosphere, ray.nu);
    AirLight light = no_air_light();
    float from = 0.0f;
    for (int i = 1; i <= cells; ++i) {
        float share = float(i) / float(cells);
        float to = end * share * share;
        add_isotropic_cell(light, atmosphere, sunlight_table, isotropic_table, phases, ray,
                           mix(from, to, SKY_VIEW_SAMPLE), to - from);
        from = to;
    }
    return light;
}

// Radiance from a direction, from altitude h [m] inside the air under a sun at mu_s.
INLINE vec3 compute_sky_view(IN(Atmosphere) atmosphere, sampler2D sunlight_table, sampler2D isotropic_table, float h,
                             float mu_s, SkyDirection direction) {
    float sines = sqrt(max((1.0f - direction.mu * direction.mu) * (1.0f - mu_s * mu_s), 0.0f));
    float nu = clamp(direction.mu * mu_s + sines * direction.cos_azimuth, -1.0f, 1.0f);
    AirRay ray = make_air_ray(atmosphere.ground_radius, h, direction.mu, mu_s, nu);
    float end = air_segment(atmosphere, ray).end;
    return march_squared(atmosphere, sunlight_table, isotropic_table, ray, end, SKY_VIEW_CELLS).inscattered;
}

SHADER_NAMESPACE_END
#endif
