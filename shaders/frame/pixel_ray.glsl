// The rays of pixels. Included by passes that read the G-buffer's depth as `depth_image`.
#ifndef ALPENGLOW_FRAME_PIXEL_RAY
#define ALPENGLOW_FRAME_PIXEL_RAY
#include "frame/air_model.glsl"
#include "frame/pixel_depth.glsl"
#include "interop/frame_block.glsl"

ViewRay view_ray(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + 0.5) * frame.inverse_size * 2.0 - 1.0 - frame.jitter;
    vec3 along = frame.ray_centre + ndc.x * frame.ray_right + ndc.y * frame.ray_up;
    float stretch = length(along), depth = pixel_depth(pixel);
    ViewRay ray;
    ray.pixel = pixel;
    ray.direction = along / stretch;
    ray.light = frame.light_from_world * ray.direction;
    ray.air = make_air_ray(frame.atmosphere.ground_radius, frame.camera_altitude, dot(ray.direction, frame.camera_up),
                           dot(frame.camera_up, frame.to_sun), dot(ray.direction, frame.to_sun));
    ray.distance = depth > 0.0 ? stretch * frame.near_plane / depth : -1.0;
    return ray;
}

#endif
