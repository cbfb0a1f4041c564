// The table of optical depth from a point to the top of the air, and what is read from it.
// Table: TRANSMITTANCE_WIDTH x TRANSMITTANCE_HEIGHT, rgb = 32nd root of optical depth; x
// the distance to the top of the air between its smallest and largest value at that altitude, y the distance to the
// horizon (Bruneton and Neyret 2008, as told by Sakmary in 3.1.1, but for his altitude axis). Only directions above the
// horizon are stored.
// Largest error where T > 1e-4, and 99th percentile, in directions chosen dense at the horizon: clear Earth 0.7 % and
// 0.27 %, hazy Earth 1.9 % and 0.5 %. Stored without the log it would be 1.2 % and 0.47 %, 5.4 % and 1.2 %.
#ifndef ALPENGLOW_ATMOSPHERE_TRANSMITTANCE_GLSL
#define ALPENGLOW_ATMOSPHERE_TRANSMITTANCE_GLSL
#include "atmosphere/optical_depth.glsl"
SHADER_NAMESPACE_BEGIN

// Altitude [m] is clamped to the air, the direction to the horizon. `along` = r mu [m].
INLINE vec2 transmittance_uv_from_altitude_along(IN(Atmosphere) atmosphere, float altitude, float along) {
    float h = clamp(altitude, 0.0f, atmosphere.top_altitude);
    float radius = atmosphere.ground_radius;
    float rho = sqrt(power_from_altitude(radius, h));
    float rho_top = sqrt(power_from_altitude(radius, atmosphere.top_altitude));
    AirRay ray = AirRay(radius, h, max(along, -rho), 0.0f, 0.0f, 0.0f);
    float nearest = atmosphere.top_altitude - h;
    float farthest = rho + rho_top;
    float x = (distance_out_of(ray, atmosphere.top_altitude) - nearest) / (farthest - nearest);
    return vec2(uv_from_unit(clamp(x, 0.0f, 1.0f), TRANSMITTANCE_WIDTH),
                uv_from_unit(rho / rho_top, TRANSMITTANCE_HEIGHT));
}

INLINE vec2 transmittance_uv_from_altitude_mu(IN(Atmosphere) atmosphere, float altitude, float mu) {
    float h = clamp(altitude, 0.0f, atmosphere.top_altitude);
    return transmittance_uv_from_altitude_along(atmosphere, h, (atmosphere.ground_radius + h) * mu);
}

// x = altitude [m], y = mu.
INLINE vec2 transmittance_altitude_mu_from_uv(IN(Atmosphere) atmosphere, vec2 uv) {
    float radius = atmosphere.ground_radius;
    float rho_top = sqrt(power_from_altitude(radius, atmosphere.top_altitude));
    float rho = rho_top * clamp(unit_from_uv(uv.y, TRANSMITTANCE_HEIGHT), 0.0f, 1.0f);
    float h = min(altitude_from_power(radius, rho * rho), atmosphere.top_altitude);
    float nearest = atmosphere.top_altitude - h;
    float x = clamp(unit_from_uv(uv.x, TRANSMITTANCE_WIDTH), 0.0f, 1.0f);
    float to_top = mix(nearest, rho + rho_top, x);
    float power = nearest * (2.0f * radius + atmosphere.top_altitude + h);
    float mu = (power - to_top * to_top) / max(2.0f * (radius + h) * to_top, TINY);
    return vec2(h, to_top > 0.0f ? clamp(mu, -1.0f, 1.0f) : 1.0f);
}

// The texel that stores an optical depth.
INLINE vec4 optical_depth_texel(vec3 depth) { return vec4(root32(depth), 1.0f); }

// From the table; directions below the horizon read the horizon's value. Above the top of the air: that of the top.
INLINE vec3 sample_optical_depth_along(sampler2D table, IN(Atmosphere) atmosphere, float h, float along) {
    return power32(vec3(sample_bilinear(table, transmittance_uv_from_altitude_along(atmosphere, h, along))));
}

INLINE vec3 sample_optical_depth(sampler2D table, IN(Atmosphere) atmosphere, float h, float mu) {
    return power32(vec3(sample_bilinear(table, transmittance_uv_from_altitude_mu(atmosphere, h, mu))));
}

struct SegmentTransmittance {
    vec3 transmittance;
    float trust; // 1: as good as the table; 0: the difference of two large depths, take the march's own sum
};

// Optical depth of the longer of the two ways above which the ratio isn't trusted at all; full trust below half of it.
// Up to there the largest error is 0.17 % on clear and hazy Earth and 0.3 % on the dense planet.
CONSTANT float SEGMENT_TRUST_DEPTH = 5.0f;

// Transmittance between two points of one ray, both inside the air and nothing but air between them, from the table:
// the depth from the lower point through the higher one to the top, less the depth from the higher one on. The ray is
// followed the way it leads up, after Bruneton and Neyret 2008, section 4, so that it never looks below the horizon.
INLINE SegmentTransmittance sample_segment_transmittance(sampler2D table, IN(Atmosphere) atmosphere, AirPoint from,
                                                         AirPoint to) {
    bool up = to.altitude >= from.altitude;
    vec3 whole = sample_optical_depth(table, atmosphere, up ? from.altitude : to.altitude, up ? from.mu : -to.mu);
    vec3 beyond = sample_optical_depth(table, atmosphere, up ? to.altitude : from.altitude, up ? to.mu : -from.mu);
    float largest = max(max(whole.x, whole.y), whole.z);
    float trust = 1.0f - smoothstep(0.5f * SEGMENT_TRUST_DEPTH, SEGMENT_TRUST_DEPTH, largest);
    return SegmentTransmittance(exp(-max(whole - beyond, vec3(0.0f))), trust);
}

SHADER_NAMESPACE_END
#endif
