// What every pass of a frame may know. Scalar layout; SI units; vectors in world axes, relative to the camera.
#ifndef ALPENGLOW_INTEROP_FRAME_H
#define ALPENGLOW_INTEROP_FRAME_H
#include "interop/atmosphere.h"
#include "interop/shadow_ceiling.h"
#include "interop/terrain_light.h"

#define FRAME_SLOT 0 // of every pass that takes FrameConstants: uniform buffer

#define MOST_CASCADES 4
#define DISC_SLICES 192 // a multiple of how often a cell looks at the sun

// Which matrix a mesh is drawn with: the view's, or that of cascade PROJECTION_CASCADE + i.
#define PROJECTION_VIEW 0
#define PROJECTION_CASCADE 1

// Flags
#define FRAME_AIR 1                 // march the air
#define FRAME_SHAFTS 2              // meshes shade the air
#define FRAME_SHADOWS 4
#define FRAME_MARCH_DITHER 8
#define FRAME_SUN_DISC 16
#define FRAME_PROCEDURAL_GROUND 32
#define FRAME_HAS_AIR 64            // the planet has any
#define FRAME_STUDIO 128            // no planet: `fill` all round, `backdrop` behind everything
#define FRAME_STARS 256
#define FRAME_AMBIENT_OCCLUSION 512

// The fine octaves of the procedural ground repeat after this length, so that a position within it is exact in float.
#define GROUND_PERIOD 8192.0f // [m]

SHADER_NAMESPACE_BEGIN

// One shadow cascade: a square around a point that the view cares about, in the sun's frame. Cascades are nested. Those
// beyond cascade_count repeat the last, so that shaders need not ask.
struct Cascade {
    float scale;  // texture coordinates = light.xy * scale + offset [1/m]
    vec2 offset;
    float texel;  // [m] width of a texel
};

struct FrameConstants {
    Atmosphere atmosphere;
#ifndef __cplusplus
    AirContent air_content;        // in C++ the Atmosphere's
#endif
    mat4 clip_from_relative[5];    // PROJECTION_…: from camera-relative world axes
    mat3 light_from_world;         // rotation: x, y across the sun's rays, z away from the sun
    vec2 light_depth;              // cascade depth = light.z * light_depth.x + light_depth.y
    Cascade cascades[MOST_CASCADES];
    int cascade_count;
    float shadow_fade;             // share of the last cascade's half width over which it fades
    ShadowCeiling ceiling;
    TerrainMap terrain;
    vec4 shaded_slabs[3];          // meshes shade the air only where dot(slab.xyz, light) + slab.w is 0 to 1 in all;
                                   // light: in the sun's frame, from the camera [m]
    float shaded_altitude;         // [m] and below this
    vec3 ray_centre;               // direction of a pixel = ray_centre + ndc.x * ray_right + ndc.y * ray_up, not unit
    vec3 ray_right;
    vec3 ray_up;
    float near_plane;              // [m] depth = near_plane / (distance along ray_centre)
    vec2 inverse_size;             // of the picture [1/pixel]
    vec2 jitter;                   // of this supersample [ndc]
    vec3 camera_up;                // unit, from the planet's centre to the camera
    float camera_altitude;         // [m] above the reference radius
    vec3 camera_planet;            // camera_position / ground_radius
    vec3 camera_in_period;         // [m] camera position modulo GROUND_PERIOD
    vec3 to_sun;                   // unit
    vec3 ground_tint;              // albedo of a uniform ground
    vec3 fill;                     // in a studio: irradiance of the even light all round, relative to the sun's
    vec3 backdrop;                 // in a studio: radiance
    float pixel_angle;             // [rad] across one pixel at the picture's centre
    float texture_bias;            // of mipmaps' levels: supersamples lie closer than pixels
    int flags;
    int samples;                   // of the march
    int shaft_looks;               // at the sun from each of its cells that a mesh can shade: at most 32
    float disc_across[DISC_SLICES]; // middles of slices of the sun's disc of the same area, from side to side, of its radius
    int exact_cells;               // even cells where a mesh can shade the air, beside `samples`; 0: some of the samples
    int sample_index;              // which supersample this is
};
CHECK_SIZE(FrameConstants, 2448);

SHADER_NAMESPACE_END
#endif
