#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/color.glsl"
#include "interop/display.h"

// sRGB, and a triangular dither of one step, so that 8 bits show no band.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = DISPLAY_SOURCE_SLOT) uniform sampler2D source;
layout(binding = DISPLAY_PICTURE_SLOT, rgba8) uniform writeonly image2D picture;
layout(push_constant, scalar) uniform Push { DisplayPush push; };

float triangular(float uniform_noise) {
    float x = uniform_noise * 2.0 - 1.0;
    return sign(x) * (1.0 - sqrt(1.0 - abs(x)));
}

vec3 dither_at(vec2 pixel) {
    return vec3(triangular(gradient_noise(pixel)), triangular(gradient_noise(pixel + vec2(37.0, 17.0))),
                triangular(gradient_noise(pixel + vec2(11.0, 59.0)))) / 255.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
    vec3 encoded = srgb_from_linear3(texelFetch(source, pixel, 0).rgb);
    if (push.dither != 0) encoded += dither_at(vec2(pixel));
    imageStore(picture, pixel, vec4(clamp(encoded, 0.0, 1.0), 1.0));
}
