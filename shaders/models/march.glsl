// Model `march`: the ray is marched, the sun's way and all further orders of scattering come from tables.
#include "atmosphere/inscattering.glsl"
#include "frame/air_model.glsl"
#include "interop/models/march.h"

layout(set = 0, binding = MARCH_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = MARCH_MULTIPLE_SCATTERING_SLOT) uniform sampler2D multiple_scattering_table;
layout(set = 0, binding = MARCH_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;

#define LIGHT_OF_TERRAIN // for passes that read its map

#ifdef LIGHT_OF_RAYS
#include "frame/air_march.glsl"

AirLight air_light(ViewRay ray) { return march_air(ray.pixel, ray.air, ray.light, ray.distance); }
#endif

vec3 lobe_light(LightMoments around, LobeTowards lobe, float mu_s) {
    return lobe_gain(surface_light_by_degree(around, lobe.up, mu_s, lobe.sun), lobe.mean_length);
}

SurfaceLight surface_light(AirPoint place, SurfaceDirections at) {
    vec3 sun = sample_sun_transmittance(sunlight_table, frame.atmosphere, place.altitude, place.mu_s);
    LightMoments around = sample_surface_light(multiple_scattering_table, frame.atmosphere, place.altitude, place.mu_s);
    LightByDegree normal = surface_light_by_degree(around, at.normal_up, place.mu_s, at.normal_sun);
    vec3 mean = power32(around.root);
    return SurfaceLight(sun, mean * irradiance_gain(normal),
                        Mirrored(mean * lobe_light(around, at.plain, place.mu_s), mean * lobe_light(around, at.grazing, place.mu_s)));
}
