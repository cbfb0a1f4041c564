// What passes ask of a model of the air. A file of shaders/models defines both functions, the first where LIGHT_OF_RAYS is defined,
// and declares the images that it reads, from AIR_MODEL_SLOT on; the passes `air`, `air_repair` and `lighting` are compiled once with each.
// A model may read `frame` and, for the light of rays, the shadow cascades: frame/sun_shadow.glsl, frame/shafts.glsl.
#ifndef ALPENGLOW_FRAME_AIR_MODEL
#define ALPENGLOW_FRAME_AIR_MODEL
#include "atmosphere/geometry.glsl"
#include "atmosphere/segment_integral.glsl"
#include "surface/brdf.glsl"

// A pixel's ray, which starts at the camera.
struct ViewRay {
    ivec2 pixel;
    vec3 direction; // unit, world axes
    vec3 light;     // the same in the sun's frame
    AirRay air;     // from the camera, which may be outside the air
    float distance; // to the surface [m]; negative: sky
};

// What lights a surface, for a unit of the sun's irradiance above the air.
struct SurfaceLight {
    vec3 sun; // share of the direct sun that air and planet let through; meshes shade it elsewhere
    vec3 sky; // irradiance from everything else: the sky, and what level ground all around gives back
    Mirrored mirrored; // of that, what its gloss reflects
};

// A direction by its cosines with the zenith and with the direction to the sun, and how closely others lie around it, 1 being at it.
struct LobeTowards {
    float up, sun;
    float mean_length;
};

// Of a surface: its normal, and where the light comes from that its gloss reflects to the camera, as surface/brdf.glsl has it.
struct SurfaceDirections {
    float normal_up, normal_sun;
    LobeTowards plain, grazing;
};

// What the air adds between the camera and the end of the ray, relative to the sun's irradiance above the air [1/sr], and
// the share of what is behind that it lets through. The planet has air.
AirLight air_light(ViewRay ray);

SurfaceLight surface_light(AirPoint place, SurfaceDirections at);

#endif
