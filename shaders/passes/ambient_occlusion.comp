#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/frame_block.glsl"
#include "encoding/octahedral.glsl"
#include "interop/ambient_occlusion.h"
#include "interop/work_list.h"
#include "atmosphere/math.glsl"

// How much of its cosine-weighted hemisphere a surface sees, by the horizons that the depth image shows in a few planes through
// the view ray (Jimenez, Wu, Pesce and Jarabo 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion", Eqs. 6 to
// 10). What hides light may be as far away as it looks wide: farther things are taken to have light behind them.
layout(local_size_x = WORK_LIST_THREADS) in;
layout(binding = AMBIENT_OCCLUSION_NORMAL_SLOT) uniform sampler2D normal_image;
layout(binding = AMBIENT_OCCLUSION_DEPTH_SLOT) uniform sampler2D depth_image;
layout(binding = AMBIENT_OCCLUSION_TERRAIN_SLOT) uniform sampler2D terrain_light_image;
layout(binding = AMBIENT_OCCLUSION_RESULT_SLOT, r32f) uniform writeonly image2D result;

#define WORK_LIST_SLOT AMBIENT_OCCLUSION_WORK_SLOT
#include "frame/pixel_work.glsl"
#include "frame/terrain_point.glsl"

const int PLANES = 2;      // of each pixel; its neighbours look into others
const int STEPS = 6;       // to each side, closer together near the pixel
const float REACH = 0.5;   // of the picture's height
const float TERRAIN_REACH = 2.0; // [texels] what is further away, the map of the light on terrain knows

// A pixel's place relative to the camera [m], by a distance of 1 m along the camera's axis.
vec3 pixel_ray(vec2 at) {
    vec2 ndc = at * frame.inverse_size * 2.0 - 1.0 - frame.jitter;
    return frame.ray_centre + ndc.x * frame.ray_right + ndc.y * frame.ray_up;
}

// The way in the picture, of length 1, that a point of the ray `along` goes if it moves along `side`.
vec2 pixel_direction(vec3 along, vec3 side) {
    vec3 change = side - along * dot(side, frame.ray_centre);
    vec2 ndc = vec2(dot(change, frame.ray_right), dot(change, frame.ray_up)) / vec2(dot(frame.ray_right, frame.ray_right), dot(frame.ray_up, frame.ray_up));
    return normalize(ndc / frame.inverse_size);
}

// One of sixteen values in [0, 1), each once in a square of 4 x 4 pixels.
float interleaved(ivec2 pixel) {
    ivec2 p = pixel & 3;
    int ordered = ((p.x ^ p.y) & 1) * 8 + (p.x & 1) * 4 + (((p.x ^ p.y) >> 1) & 1) * 2 + ((p.x >> 1) & 1);
    return (float(ordered) + 0.5) / 16.0;
}

// Sine of the elevation above the surface of the highest thing to one side. Measured from the surface and not in the plane: pixels
// lie a little beside it.
float highest(vec3 place, vec3 normal, vec2 from, vec2 towards, float offset, float reach) {
    float found = 0.0;
    vec2 size = 1.0 / frame.inverse_size;
    for (int i = 0; i < STEPS; ++i) {
        float share = (float(i) + offset) / float(STEPS);
        vec2 at = floor(from + towards * (share * share) + sign(towards)) + 0.5;
        bool inside = all(greaterThan(at, vec2(0.0))) && all(lessThan(at, size));
        float depth = texelFetch(depth_image, ivec2(clamp(at, vec2(0.0), size - 1.0)), 0).r;
        vec3 apart = pixel_ray(at) * (frame.near_plane / max(depth, 1e-30)) - place;
        float length2 = dot(apart, apart);
        float trust = inside && depth > 0.0 ? clamp(2.0 - 2.0 * sqrt(length2) / reach, 0.0, 1.0) : 0.0;
        found = max(found, trust * dot(apart, normal) * inversesqrt(max(length2, 1e-12)));
    }
    return found;
}

// The share of the light within a plane, from the normal's angle and that of the horizon, both from the direction to the camera.
float seen_to_one_side(float horizon, float normal) {
    return 0.25 * (cos(normal) - cos(2.0 * horizon - normal) + 2.0 * horizon * sin(normal));
}

float visibility(ivec2 pixel, float depth) {
    vec2 from = vec2(pixel) + 0.5;
    vec3 along = pixel_ray(from);
    float distance = frame.near_plane / depth;
    vec3 to_camera = -normalize(along);
    vec3 place = along * distance;
    vec3 normal = unit_from_octahedral(texelFetch(normal_image, pixel, 0).xy);
    float pixels = REACH / frame.inverse_size.y, reach = 2.0 * REACH * length(frame.ray_up) * distance;
    reach = mix(reach, min(reach, TERRAIN_REACH * frame.terrain.texel), terrain_point(place).share);
    float turn = interleaved(pixel), offset = fract(turn * 4.0 + 0.125);
    vec3 level = normalize(frame.ray_right - dot(frame.ray_right, to_camera) * to_camera);
    float sum = 0.0;
    for (int i = 0; i < PLANES; ++i) {
        float angle = PI * (float(i) + turn) / float(PLANES);
        vec3 side = cos(angle) * level + sin(angle) * cross(to_camera, level);
        vec2 towards = pixel_direction(along, side);
        vec3 in_plane = normal - dot(normal, cross(side, to_camera)) * cross(side, to_camera);
        float share = max(length(in_plane), 1e-3);
        float tilt = atan(dot(in_plane, side), dot(in_plane, to_camera));
        float right = asin(min(highest(place, normal, from, towards * pixels, offset, reach) / share, 1.0));
        float left = asin(min(highest(place, normal, from, -towards * pixels, offset, reach) / share, 1.0));
        sum += share * (seen_to_one_side(tilt + 0.5 * PI - right, tilt) + seen_to_one_side(tilt - 0.5 * PI + left, tilt));
    }
    return clamp(sum / float(PLANES), 0.0, 1.0);
}

void main() {
    PixelBlock block = listed_block(SURFACE_WORK);
    int row = 0;
    do {
        ivec2 pixel = pixel_of(block, row, imageSize(result));
        float depth = texelFetch(depth_image, pixel, 0).r, seen = visibility(pixel, depth);
        if (block.listed && depth > 0.0) imageStore(result, pixel, vec4((frame.flags & FRAME_AMBIENT_OCCLUSION) != 0 ? seen : 1.0));
    } while (++row < PIXEL_WORK_ROWS);
}
