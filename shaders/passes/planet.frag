#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "atmosphere/geometry.glsl"
#include "encoding/octahedral.glsl"
#include "interop/gbuffer.h"
#include "surface/brdf.glsl"
#include "surface/planet_look.glsl"

// The planet's body, where nothing nearer stands: a sphere hit by the pixel's ray, with its own depth.

layout(location = 0) in vec2 ndc;

layout(location = GBUFFER_ALBEDO_TARGET) out vec4 out_albedo;
layout(location = GBUFFER_NORMAL_TARGET) out vec4 out_normal;
layout(location = GBUFFER_MATERIAL_TARGET) out vec4 out_material;
layout(location = GBUFFER_EMISSION_TARGET) out vec3 out_emission;

void main() {
    vec2 at = ndc - frame.jitter;
    vec3 along = frame.ray_centre + at.x * frame.ray_right + at.y * frame.ray_up;
    float stretch = length(along);
    vec3 direction = along / stretch;
    float mu = dot(direction, frame.camera_up);
    float radius = frame.atmosphere.ground_radius;
    AirRay ray = make_air_ray(radius, frame.camera_altitude, mu, 0.0, 0.0);
    bool hit = ray_hits_ground(ray);
    float distance = distance_into(ray, 0.0);

    vec3 unit = normalize(frame.camera_planet + direction * (distance / radius));
    float facing = max(dot(unit, -direction), 0.02);
    // A software device runs the look for the sky's pixels too: there no octave is wide enough to be seen.
    float footprint = hit ? frame.pixel_angle * distance * inversesqrt(facing) : 4.0 * radius;
    GroundLookAt look;
    look.albedo = frame.ground_tint;
    look.roughness = 1.0;
    look.water = 0.0;
    float gloss = 0.0; // a uniform ground sends back its albedo, as the air's tables take it to
    if ((frame.flags & FRAME_PROCEDURAL_GROUND) != 0) {
        gloss = 1.0;
        vec3 in_period = mod(frame.camera_in_period + direction * distance, vec3(GROUND_PERIOD));
        look = planet_look(unit, in_period, footprint / radius, radius);
    }
    if (!hit) discard;
    vec2 normal = octahedral_from_unit(unit);
    out_albedo = vec4(look.albedo, 1.0);
    out_normal = vec4(normal, normal);
    out_material = vec4(look.roughness, 0.0, gloss, USUAL_REFLECTANCE / LARGEST_REFLECTANCE);
    out_emission = vec3(0.0);
    gl_FragDepth = frame.near_plane * stretch / distance;
}
