// The sky's irradiance on level ground by altitude and sun, as the model `tables` has it; per unit of solar irradiance
// above the air. Table: SKY_LIGHT_WIDTH x SKY_LIGHT_HEIGHT, rgb = its 32nd root.
#ifndef ALPENGLOW_MODELS_TABLES_SKY_LIGHT_GLSL
#define ALPENGLOW_MODELS_TABLES_SKY_LIGHT_GLSL
#include "models/tables/isotropic.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT int SKY_LIGHT_ZENITHS = 32;
CONSTANT int SKY_LIGHT_AZIMUTHS = 16; // of half a turn; dense towards the sun, azimuth = pi x²
CONSTANT int SKY_LIGHT_CELLS = 24;

// By integration over the upper hemisphere at altitude h [m], without the direct sun.
INLINE vec3 compute_sky_light(IN(Atmosphere) atmosphere, sampler2D sunlight_table, sampler2D isotropic_table, float h,
                              float mu_s) {
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 0.0f));
    vec3 irradiance = vec3(0.0f);
    for (int i = 0; i < SKY_LIGHT_ZENITHS * SKY_LIGHT_AZIMUTHS; ++i) {
        float zenith = (float(i / SKY_LIGHT_AZIMUTHS) + 0.5f) / float(SKY_LIGHT_ZENITHS) * 0.5f * PI;
        float x = (float(i % SKY_LIGHT_AZIMUTHS) + 0.5f) / float(SKY_LIGHT_AZIMUTHS);
        float mu = cos(zenith);
        float nu = clamp(mu * mu_s + sin(zenith) * sin_sun * cos(PI * x * x), -1.0f, 1.0f);
        AirRay ray = make_air_ray(atmosphere.ground_radius, h, mu, mu_s, nu);
        RayPhases phases = phases_of(atmosphere, nu);
        MarchCells cells = make_march_cells(atmosphere, ray, 0.0f, max(distance_out_of(ray, atmosphere.top_altitude), 0.0f));
        AirLight light = no_air_light();
        float from = 0.0f;
        for (int j = 0; j < SKY_LIGHT_CELLS; ++j) {
            MarchCell cell = march_cell_from(cells, from, j, SKY_LIGHT_CELLS);
            from = cell.end;
            add_isotropic_cell(light, atmosphere, sunlight_table, isotropic_table, phases, ray, cell.middle,
                               cell.end - cell.begin);
        }
        irradiance += light.inscattered * (mu * sin(zenith) * x);
    }
    // d(solid angle) = sin(zenith) d(zenith) · 2 pi x dx, twice for the two halves of the sky.
    return irradiance * (2.0f * PI * PI / (float(SKY_LIGHT_ZENITHS) * float(SKY_LIGHT_AZIMUTHS)));
}

INLINE vec3 sample_sky_light(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu_s) {
    return power32(vec3(sample_bilinear(table, sun_table_uv(atmosphere, h, mu_s, SKY_LIGHT_WIDTH, SKY_LIGHT_HEIGHT))));
}

SHADER_NAMESPACE_END
#endif
