// Rays through the air of a sphere, in float. r = R + h is the distance from the planet's centre, R its radius; mu the
// cosine between a direction and the zenith, mu_s that of the direction to the sun.
// Heights come from powers of points, r² - R² = h (2R + h), and never from the difference r - R.
#ifndef ALPENGLOW_ATMOSPHERE_GEOMETRY_GLSL
#define ALPENGLOW_ATMOSPHERE_GEOMETRY_GLSL
#include "atmosphere/math.glsl"
#include "interop/atmosphere.h"
SHADER_NAMESPACE_BEGIN

struct AirRay {
    float ground_radius; // R [m]
    float altitude;      // of the origin, h0 [m]
    float along;         // r0 mu0 [m]: distance travelled since the closest approach to the centre; negative before it
    float sun_along;     // r0 mu_s0 [m]
    float nu;            // cosine between the ray's direction and the direction to the sun
};

// A point of a ray.
struct AirPoint {
    float altitude; // [m]
    float mu;       // of the ray
    float mu_s;     // of the sun
};

// The part of a ray between two distances from its origin.
struct AirSegment {
    float begin;      // [m]
    float end;        // [m] >= begin
    bool hits_ground; // the sphere of radius R is where the segment ends
};

// A ray that starts at altitude h [m] >= -R/2. Directions are unit vectors; mu, mu_s and nu their cosines.
INLINE AirRay make_air_ray(float ground_radius, float h, float mu, float mu_s, float nu) {
    float r = ground_radius + h;
    return AirRay(ground_radius, h, r * mu, r * mu_s, nu);
}

// The altitude [m] whose power r² - R² is given [m²]; 0 or less below R.
INLINE float altitude_from_power(float ground_radius, float power) {
    return power / (ground_radius + sqrt(max(ground_radius * ground_radius + power, 0.0f)));
}

INLINE float power_from_altitude(float ground_radius, float h) { return h * (2.0f * ground_radius + h); }

// The difference in power between altitude h [m] and the origin [m²].
INLINE float power_above_origin(AirRay ray, float h) {
    return (h - ray.altitude) * (2.0f * ray.ground_radius + h + ray.altitude);
}

// The altitude [m] at distance t [m]. In float, on Earth: within 0.03 m for an origin below 100 km; for one above that
// `enter_air` has brought down to the top, 0.13 m from 400 km, 0.25 m from 1000 km and 17 m from 20 000 km.
INLINE float altitude_at(AirRay ray, float t) {
    float power = power_from_altitude(ray.ground_radius, ray.altitude) + t * (2.0f * ray.along + t);
    return altitude_from_power(ray.ground_radius, power);
}

// The altitude [m] of the ray's closest approach to the planet's centre, whether before or behind the origin.
INLINE float closest_altitude(AirRay ray) {
    float power = power_from_altitude(ray.ground_radius, ray.altitude) - ray.along * ray.along;
    return altitude_from_power(ray.ground_radius, power);
}

// Altitude and cosines at distance t [m]: r mu grows by t, r mu_s by t nu.
INLINE AirPoint air_point_at(AirRay ray, float t) {
    float h = altitude_at(ray, t);
    float r = ray.ground_radius + h;
    return AirPoint(h, clamp((ray.along + t) / r, -1.0f, 1.0f), clamp((ray.sun_along + t * ray.nu) / r, -1.0f, 1.0f));
}

// Distance [m] at which the ray leaves the sphere of altitude h, for an origin inside it.
INLINE float distance_out_of(AirRay ray, float h) {
    float power = power_above_origin(ray, h);
    float root = sqrt(max(ray.along * ray.along + power, 0.0f));
    return ray.along > 0.0f ? power / max(ray.along + root, TINY) : root - ray.along;
}

// Distance [m] at which the ray enters the sphere of altitude h; for an origin outside it and a ray that meets it.
INLINE float distance_into(AirRay ray, float h) {
    float power = power_above_origin(ray, h);
    float root = sqrt(max(ray.along * ray.along + power, 0.0f));
    return -power / max(root - ray.along, TINY);
}

// Whether the ray, from an origin at or above sea level, meets the sphere of radius R ahead.
INLINE bool ray_hits_ground(AirRay ray) {
    return ray.along < 0.0f && ray.along * ray.along >= power_from_altitude(ray.ground_radius, ray.altitude);
}

// The same ray from where it enters the air, `distance` [m] ahead; unchanged, with 0, for an origin inside. For a ray
// that misses the air `distance` means nothing, and its `air_segment` is empty.
INLINE AirRay enter_air(Atmosphere atmosphere, AirRay ray, OUT(float) distance) {
    bool outside = ray.altitude > atmosphere.top_altitude;
    float power = power_above_origin(ray, atmosphere.top_altitude);
    float root = sqrt(max(ray.along * ray.along + power, 0.0f));
    distance = outside && ray.along < 0.0f ? -power / (root - ray.along) : 0.0f;
    AirRay entered = ray;
    entered.altitude = min(ray.altitude, atmosphere.top_altitude);
    entered.along = outside ? (ray.along < 0.0f ? -root : root) : ray.along;
    entered.sun_along = ray.sun_along + distance * ray.nu;
    return entered;
}

// The part of the ray inside the air and above the ground, for an origin inside the air.
INLINE AirSegment air_segment(Atmosphere atmosphere, AirRay ray) {
    bool hits = ray_hits_ground(ray);
    float out_of_air = distance_out_of(ray, atmosphere.top_altitude);
    return AirSegment(0.0f, max(hits ? distance_into(ray, 0.0f) : out_of_air, 0.0f), hits);
}

// Cosine of the zenith angle of the geometric horizon, seen from altitude h [m] >= 0: 91.016 degrees at 1 km on Earth.
INLINE float horizon_mu(float ground_radius, float h) {
    return -sqrt(max(power_from_altitude(ground_radius, h), 0.0f)) / (ground_radius + h);
}

SHADER_NAMESPACE_END
#endif
