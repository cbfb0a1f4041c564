#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/tone_curves.glsl"
#include "encoding/octahedral.glsl"
#include "interop/display.h"

// Any image of the frame, stretched over the picture; layers stand side by side.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = SHOW_IMAGE_SLOT) uniform sampler2DArray shown;
layout(binding = SHOW_PICTURE_SLOT, rgba8) uniform writeonly image2D picture;
layout(binding = SHOW_EXPOSURE_SLOT) uniform sampler2D exposure;
layout(constant_id = 0) const int curve = CURVE_FILMIC;
layout(push_constant, scalar) uniform Push { ShowPush push; };

// The order of render/frame_graph.h: ShowScale.
const int ENCODED = 0, RADIANCE = 1, UNIT = 2, NORMAL = 3, DEPTH = 4, SHADOW = 5, OPTICAL_DEPTH = 6, LOGARITHM = 7;

// Dark blue to yellow with even steps of lightness: a fit by eye of the viridis scale.
vec3 scale_color(float x) {
    vec3 c0 = vec3(0.267, 0.005, 0.329), c1 = vec3(0.229, 0.322, 0.545), c2 = vec3(0.128, 0.567, 0.551);
    vec3 c3 = vec3(0.369, 0.789, 0.383), c4 = vec3(0.993, 0.906, 0.144);
    float t = clamp(x, 0.0, 1.0) * 4.0;
    return mix(mix(mix(mix(c0, c1, clamp(t, 0.0, 1.0)), c2, clamp(t - 1.0, 0.0, 1.0)), c3, clamp(t - 2.0, 0.0, 1.0)), c4, clamp(t - 3.0, 0.0, 1.0));
}

vec3 encoded(vec4 texel) {
    vec3 exposed = texel.rgb * texelFetch(exposure, ivec2(0), 0).r;
    // 0.1 m to 100 000 km, nine decades; nothing there is black
    float decades = log2(push.near_plane / max(texel.r, 1e-12)) * 0.30103;
    switch (push.scale) {
    case ENCODED: return texel.rgb;
    case RADIANCE: return srgb_from_linear3(tone_curve(curve, exposed));
    case UNIT: return srgb_from_linear3(clamp(texel.rgb, 0.0, 1.0));
    case NORMAL: return unit_from_octahedral(texel.xy) * 0.5 + 0.5;
    case DEPTH: return texel.r > 0.0 ? scale_color((decades + 1.0) / 9.0) : vec3(0.0);
    case SHADOW: return vec3(texel.r);
    case OPTICAL_DEPTH: return srgb_from_linear3(exp(-texel.rgb));
    default: return clamp(log(max(texel.rgb, 1e-30)) * (32.0 / 13.8) + 1.0, 0.0, 1.0);
    }
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 at = (vec2(pixel) + 0.5) / vec2(size);
    float layer = floor(at.x * float(push.layers));
    vec4 texel = textureLod(shown, vec3(at.x * float(push.layers) - layer, at.y, layer), 0.0);
    imageStore(picture, pixel, vec4(encoded(texel), 1.0));
}
