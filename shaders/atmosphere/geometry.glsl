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
    float along_low;     // what rounding took from `along` [m]; from far outside the air it moves the limb by a metre
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
    TwoFloat r = two_sum(ground_radius, h);
    TwoFloat along = two_product(r.high, mu);
    return AirRay(ground_radius, h, along.high, r.high * mu_s, nu, along.low + r.low * mu);
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

// The altitude [m] at distance t [m]. In float, on Earth, inside the air: within 0.05 m for an origin there, or for one
// up to 20 000 km high that `enter_air` has brought down to the top.
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

// along² + the power of altitude h above the origin [m²], for an origin far above it: two numbers of the square of the
// planet's radius nearly cancel, so that both are kept with what rounding takes from them.
INLINE float squared_along_at(AirRay ray, float h) {
    TwoFloat square = two_product(ray.along, ray.along);
    TwoFloat down = two_sum(h, -ray.altitude), sum = two_sum(2.0f * ray.ground_radius, h + ray.altitude);
    TwoFloat power = two_product(down.high, sum.high);
    float low = square.low + 2.0f * ray.along * ray.along_low + power.low + down.high * sum.low + down.low * sum.high;
    return (square.high + power.high) + low;
}

// The same ray from where it enters the air, `distance` [m] ahead; unchanged, with 0, for an origin inside. For a ray
// that misses the air `distance` means nothing, and its `air_segment` is empty.
INLINE AirRay enter_air(IN(Atmosphere) atmosphere, AirRay ray, OUT(float) distance) {
    bool outside = ray.altitude > atmosphere.top_altitude;
    float power = power_above_origin(ray, atmosphere.top_altitude);
    float root = sqrt(max(squared_along_at(ray, atmosphere.top_altitude), 0.0f));
    distance = outside && ray.along < 0.0f ? -power / (root - ray.along) : 0.0f;
    AirRay entered = ray;
    entered.altitude = min(ray.altitude, atmosphere.top_altitude);
    entered.along = outside ? (ray.along < 0.0f ? -root : root) : ray.along;
    entered.along_low = 0.0f;
    entered.sun_along = ray.sun_along + distance * ray.nu;
    return entered;
}

// What lies at distance t [m] of a ray from anywhere: from outside the air told from where the ray enters it, since from
// 20 000 km altitudes would be 17 m off.
INLINE AirPoint place_at(IN(Atmosphere) atmosphere, AirRay ray, float t) {
    float entry = 0.0f;
    AirRay inside = enter_air(atmosphere, ray, entry);
    bool enters = entry > 0.0f && closest_altitude(ray) < atmosphere.top_altitude;
    AirPoint from_entry = air_point_at(inside, t - entry), from_origin = air_point_at(ray, t);
    return AirPoint(enters ? from_entry.altitude : from_origin.altitude, enters ? from_entry.mu : from_origin.mu,
                    enters ? from_entry.mu_s : from_origin.mu_s);
}

// The part of the ray inside the air and above the ground, for an origin inside the air.
INLINE AirSegment air_segment(IN(Atmosphere) atmosphere, AirRay ray) {
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
