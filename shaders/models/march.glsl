// Model `march`: the ray is marched, the sun's way and all further orders of scattering come from tables.
#include "atmosphere/inscattering.glsl"
#include "frame/air_model.glsl"
#include "interop/models/march.h"

layout(set = 0, binding = MARCH_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;
layout(set = 0, binding = MARCH_MULTIPLE_SCATTERING_SLOT) uniform sampler2D multiple_scattering_table;

#include "frame/air_march.glsl"

AirLight air_light(ViewRay ray) { return march_air(ray.pixel, ray.air, ray.light, ray.distance); }

SurfaceLight surface_light(AirPoint place, float normal_up, float normal_sun) {
    vec3 sun = sample_sun_transmittance(transmittance_table, frame.atmosphere, place.altitude, place.mu_s);
    vec3 sky = sample_diffuse_irradiance(multiple_scattering_table, frame.atmosphere, place.altitude, place.mu_s, normal_up, normal_sun);
    return SurfaceLight(sun, sky);
}
