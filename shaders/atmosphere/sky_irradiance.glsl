// The sky's irradiance on a horizontal plane that faces up, by altitude and sun, without the direct sun; per unit of
// solar irradiance above the air.
// Table: SKY_IRRADIANCE_WIDTH x SKY_IRRADIANCE_HEIGHT, rgb = its 32nd root, because it spans ten powers of ten in twilight.
#ifndef ALPENGLOW_ATMOSPHERE_SKY_IRRADIANCE_GLSL
#define ALPENGLOW_ATMOSPHERE_SKY_IRRADIANCE_GLSL
#include "atmosphere/inscattering.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT int SKY_IRRADIANCE_ZENITHS = 32;
CONSTANT int SKY_IRRADIANCE_AZIMUTHS = 16; // of half a turn; dense towards the sun, azimuth = pi x²
CONSTANT int SKY_IRRADIANCE_CELLS = 24;

// By integration over the upper hemisphere at altitude h [m], with all orders of scattering.
INLINE vec3 compute_sky_irradiance(Atmosphere atmosphere, sampler2D transmittance_table,
                                   sampler2D multiple_scattering_table, float h, float mu_s) {
    float sin_sun = sqrt(max(1.0f - mu_s * mu_s, 0.0f));
    vec3 irradiance = vec3(0.0f);
    for (int i = 0; i < SKY_IRRADIANCE_ZENITHS * SKY_IRRADIANCE_AZIMUTHS; ++i) {
        float zenith = (float(i / SKY_IRRADIANCE_AZIMUTHS) + 0.5f) / float(SKY_IRRADIANCE_ZENITHS) * 0.5f * PI;
        float x = (float(i % SKY_IRRADIANCE_AZIMUTHS) + 0.5f) / float(SKY_IRRADIANCE_AZIMUTHS);
        float mu = cos(zenith);
        float nu = clamp(mu * mu_s + sin(zenith) * sin_sun * cos(PI * x * x), -1.0f, 1.0f);
        AirRay ray = make_air_ray(atmosphere.ground_radius, h, mu, mu_s, nu);
        float end = max(distance_out_of(ray, atmosphere.top_altitude), 0.0f);
        AirLight light = compute_air_light(atmosphere, transmittance_table, multiple_scattering_table, ray, 0.0f, end,
                                           SKY_IRRADIANCE_CELLS);
        irradiance += light.inscattered * (mu * sin(zenith) * x);
    }
    // d(solid angle) = sin(zenith) d(zenith) · 2 pi x dx, twice for the two halves of the sky.
    float weight = 2.0f * PI * PI / (float(SKY_IRRADIANCE_ZENITHS) * float(SKY_IRRADIANCE_AZIMUTHS));
    return irradiance * weight;
}

// The texel that stores an irradiance, and the irradiance from the table.
INLINE vec4 sky_irradiance_texel(vec3 irradiance) { return vec4(root32(irradiance), 1.0f); }

INLINE vec3 sample_sky_irradiance(sampler2D table, Atmosphere atmosphere, float h, float mu_s) {
    vec2 uv = sun_table_uv(atmosphere, h, mu_s, SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT);
    return power32(vec3(sample_bilinear(table, uv)));
}

// Irradiance on a plane whose normal has the cosine `cos_up` with the zenith, between an even sky of the horizontal
// irradiance `sky` and level ground all around whose radiosity (sun and sky on it, times its albedo) is `ground`.
INLINE vec3 sky_irradiance_on_normal(vec3 sky, vec3 ground, float cos_up) {
    return sky * (0.5f + 0.5f * cos_up) + ground * (0.5f - 0.5f * cos_up);
}

SHADER_NAMESPACE_END
#endif
