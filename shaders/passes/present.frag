#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/color.glsl"
#include "interop/present.h"

// The picture on the whole window, with a linear filter where their sizes differ.
layout(binding = PRESENT_PICTURE_SLOT) uniform sampler2D picture;
layout(push_constant, scalar) uniform Push { PresentPush push; };

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 color;

void main() {
    vec3 encoded = textureLod(picture, ndc * 0.5 + 0.5, 0.0).rgb;
    color = vec4(push.decode != 0 ? linear_from_srgb3(encoded) : encoded, 1.0);
}
