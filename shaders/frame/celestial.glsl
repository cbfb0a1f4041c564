// What stands behind the air: the sun's disc and the stars. Included by the lighting pass.
#ifndef ALPENGLOW_FRAME_CELESTIAL
#define ALPENGLOW_FRAME_CELESTIAL
#include "atmosphere/stars.glsl"
#include "atmosphere/sun_disc.glsl"

const int SUN_CHORDS = 16; // for a pixel; 1e-3 of the disc's light at worst

ViewPixel view_pixel(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + 0.5) * frame.inverse_size * 2.0 - 1.0 - frame.jitter;
    vec3 along = frame.ray_centre + ndc.x * frame.ray_right + ndc.y * frame.ray_up;
    return ViewPixel(frame.ray_centre, along, 2.0 * frame.inverse_size.x * frame.ray_right, 2.0 * frame.inverse_size.y * frame.ray_up);
}

// `turn`: cosine and sine of the angle about the planet's axis from the world's to the celestial sphere.
vec3 celestial_from_world(vec3 v, vec2 turn) { return vec3(turn.x * v.x + turn.y * v.y, turn.x * v.y - turn.y * v.x, v.z); }

// Radiance of a pixel of the sky behind the air, relative as the sun's irradiance is. `in_front`: the air's own light.
vec3 celestial_radiance(ivec2 pixel, vec3 in_front, vec2 turn) {
    ViewPixel view = view_pixel(pixel);
    Atmosphere planet = frame.atmosphere;
    DiscPixel disc = disc_pixel(view.along, view.right, view.down, frame.to_sun, planet.sun_angular_radius);
    bool sunlit = (frame.flags & FRAME_SUN_DISC) != 0 && meets_disc(disc, view.along, frame.to_sun);
    vec3 sun = disc_share(disc, sunlit ? SUN_CHORDS : 0) * sun_mean_radiance(planet.sun_angular_radius);

    bool dark = luminance(in_front) < drowning_radiance(view) * luminance(planet.solar_irradiance);
    ViewPixel turned = ViewPixel(celestial_from_world(view.centre, turn), celestial_from_world(view.along, turn),
                                 celestial_from_world(view.right, turn), celestial_from_world(view.down, turn));
    vec3 stars = star_radiance(turned, (frame.flags & FRAME_STARS) != 0 && dark) * luminance(planet.solar_irradiance);
    return sun * planet.solar_irradiance + stars;
}

#endif
