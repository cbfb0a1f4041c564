#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "encoding/color.glsl"
#include "interop/overlay.h"

layout(binding = OVERLAY_TEXTURE_SLOT) uniform sampler2D glyphs;
layout(push_constant, scalar) uniform Push { OverlayPush push; };

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 result;

void main() {
    vec4 encoded = color * textureLod(glyphs, uv, 0.0);
    result = vec4(push.decode != 0 ? linear_from_srgb3(encoded.rgb) : encoded.rgb, encoded.a);
}
