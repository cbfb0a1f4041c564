// Model `tables`: the sky from a table of the view's directions, the air before surfaces from a table of the view's frustum
// (Hillaire 2020; Sakmary, chapters 3 and 4). From outside the air, where neither applies, the ray is marched.
#include "frame/air_model.glsl"
#include "models/tables/aerial_perspective.glsl"
#include "models/tables/sky_light.glsl"
#include "models/tables/sky_view.glsl"

layout(set = 0, binding = TABLES_SUNLIGHT_SLOT) uniform sampler2D sunlight_table;
layout(set = 0, binding = TABLES_ISOTROPIC_SLOT) uniform sampler2D isotropic_table;
layout(set = 0, binding = TABLES_SKY_LIGHT_SLOT) uniform sampler2D sky_light_table;
layout(set = 0, binding = TABLES_SKY_VIEW_SLOT) uniform sampler2D sky_view_table;
layout(set = 0, binding = TABLES_AERIAL_SLOT) uniform sampler2D aerial_table;
layout(set = 0, binding = TABLES_TRANSMITTANCE_SLOT) uniform sampler2D transmittance_table;

#ifdef LIGHT_OF_RAYS
const float SAME_PLACE = 2e-3; // share of a distance within which a surface is the planet's own

// The sky, or the planet's own surface, in whose direction the table of the sky ends there too.
AirLight sky_view_light(ViewRay ray) {
    Atmosphere atmosphere = frame.atmosphere;
    bool ground = ray_hits_ground(ray.air);
    AirPoint camera = air_point_at(ray.air, 0.0);
    float sines = sqrt(max((1.0 - camera.mu * camera.mu) * (1.0 - camera.mu_s * camera.mu_s), 1e-12));
    float cos_azimuth = clamp((ray.air.nu - camera.mu * camera.mu_s) / sines, -1.0, 1.0);
    vec2 uv = sky_view_uv(atmosphere, camera.altitude, SkyDirection(camera.mu, cos_azimuth), ground);
    AirPoint end = air_point_at(ray.air, ground ? distance_into(ray.air, 0.0) : distance_out_of(ray.air, atmosphere.top_altitude));
    vec3 transmittance = sample_segment_transmittance(transmittance_table, atmosphere, camera, end).transmittance;
    return AirLight(sample_bilinear(sky_view_table, uv).rgb, transmittance);
}

AirLight outside_light(ViewRay view, bool outside) {
    float entry;
    AirRay ray = enter_air(frame.atmosphere, view.air, entry);
    float end = view.distance < 0.0 ? air_segment(frame.atmosphere, ray).end
                                    : min(view.distance - entry, distance_out_of(ray, frame.atmosphere.top_altitude));
    bool misses = end <= 0.0 || closest_altitude(view.air) >= frame.atmosphere.top_altitude;
    // No cells rather than a branch: software devices run both sides of one.
    return march_squared(frame.atmosphere, sunlight_table, isotropic_table, ray, end, outside && !misses ? SKY_VIEW_CELLS : 0);
}

AirLight air_light(ViewRay ray) {
    bool outside = ray.air.altitude > frame.atmosphere.top_altitude;
    AirLight marched = outside_light(ray, outside);
    if (outside) return marched;
    bool hits = ray_hits_ground(ray.air);
    bool bare = hits && abs(distance_into(ray.air, 0.0) - ray.distance) < SAME_PLACE * ray.distance;
    if (ray.distance < 0.0 || bare) return sky_view_light(ray);
    vec2 ndc = (vec2(ray.pixel) + 0.5) * frame.inverse_size * 2.0 - 1.0 - frame.jitter;
    float reach = aerial_reach(frame.atmosphere.ground_radius, frame.camera_altitude);
    return sample_aerial_perspective(aerial_table, reach, 0.5 + 0.5 * ndc, ray.distance);
}
#endif

SurfaceLight surface_light(AirPoint place, SurfaceDirections at) {
    vec3 sky = sample_sky_light(sky_light_table, frame.atmosphere, place.altitude, place.mu_s);
    vec3 sun = sample_sun_transmittance(sunlight_table, frame.atmosphere, place.altitude, place.mu_s);
    vec3 ground = (sky + sun * max(place.mu_s, 0.0)) * frame.atmosphere.ground_albedo;
    vec3 irradiance = sky * (0.5 + 0.5 * at.normal_up) + ground * (0.5 - 0.5 * at.normal_up);
    return SurfaceLight(sun, irradiance, Mirrored(irradiance / PI, irradiance / PI));
}
