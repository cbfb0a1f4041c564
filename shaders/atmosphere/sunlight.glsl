// The table of the sun's light that gets through the air to a point, and what is read from it: the mean over the part of its disc
// that stands above the horizon, since close to it the air lets several times more of the disc's upper edge through than of its lower one.
// Table: shape and axes of the transmittance table, for the direction to the disc's upper edge; rgb = 32nd root of the optical depth
// whose transmittance is that mean.
#ifndef ALPENGLOW_ATMOSPHERE_SUNLIGHT_GLSL
#define ALPENGLOW_ATMOSPHERE_SUNLIGHT_GLSL
#include "atmosphere/sun_share.glsl"
#include "atmosphere/transmittance.glsl"
SHADER_NAMESPACE_BEGIN

CONSTANT int SUN_SLICES = 12;

// By how much the disc's radius changes r mu [m]: exact close to the horizon, where the mean matters.
INLINE float sun_reach(IN(Atmosphere) atmosphere) {
    return max(atmosphere.sun_angular_radius, 1e-6f) * atmosphere.ground_radius;
}

// The share of the sun's disc above the geometric horizon, exactly 0 to exactly 1, from altitude h [m]. `sun_along` = r mu_s [m],
// of the disc's centre.
INLINE float sun_above_horizon_along(IN(Atmosphere) atmosphere, float h, float sun_along) {
    float above = sun_along + sqrt(power_from_altitude(atmosphere.ground_radius, max(h, 0.0f)));
    return disc_share_above(above / sun_reach(atmosphere));
}

INLINE float sun_above_horizon(IN(Atmosphere) atmosphere, float h, float mu_s) {
    return sun_above_horizon_along(atmosphere, h, (atmosphere.ground_radius + max(h, 0.0f)) * mu_s);
}

// What the table holds for a disc whose upper edge stands at mu, at altitude h [m] inside the air: slices of the disc, all as high.
INLINE vec3 compute_sunlight_depth(sampler2D transmittance_table, IN(Atmosphere) atmosphere, float h, float mu) {
    float edge = (atmosphere.ground_radius + h) * mu, reach = sun_reach(atmosphere);
    float above = (edge + sqrt(power_from_altitude(atmosphere.ground_radius, h))) / reach; // of the upper edge [disc radii]
    float from = asin(clamp(1.0f - above, -1.0f, 1.0f)); // the lowest that is seen; slices by the arcsine of their place
    vec3 least = sample_optical_depth_along(transmittance_table, atmosphere, h, edge);
    vec3 sum = vec3(0.0f); // relative to the edge: thick air leaves less than a float can hold
    float area = 0.0f;
    for (int i = 0; i < SUN_SLICES; ++i) {
        float angle = mix(from, 0.5f * PI, (float(i) + 0.5f) / float(SUN_SLICES));
        float along = edge + (sin(angle) - 1.0f) * reach, share = max(cos(angle) * cos(angle), 1e-9f);
        sum += exp(least - sample_optical_depth_along(transmittance_table, atmosphere, h, along)) * share;
        area += share;
    }
    return max(least - log(sum / area), vec3(0.0f));
}

// The share of the sun's light above the air that reaches a point at altitude h [m]: air, and the planet's own shadow.
// `sun_along` = r mu_s [m].
INLINE vec3 sample_sun_transmittance_along(sampler2D sunlight_table, IN(Atmosphere) atmosphere, float h, float sun_along) {
    vec3 depth = sample_optical_depth_along(sunlight_table, atmosphere, h, sun_along + sun_reach(atmosphere));
    return exp(-depth) * sun_above_horizon_along(atmosphere, h, sun_along);
}

INLINE vec3 sample_sun_transmittance(sampler2D sunlight_table, IN(Atmosphere) atmosphere, float h, float mu_s) {
    return sample_sun_transmittance_along(sunlight_table, atmosphere, h, (atmosphere.ground_radius + max(h, 0.0f)) * mu_s);
}

SHADER_NAMESPACE_END
#endif
