#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/overlay.h"

layout(push_constant, scalar) uniform Push { OverlayPush push; };

layout(location = OVERLAY_PLACE) in vec2 place;
layout(location = OVERLAY_UV) in vec2 uv;
layout(location = OVERLAY_COLOR) in vec4 color;

layout(location = 0) out vec2 out_uv;
layout(location = 1) out vec4 out_color;

void main() {
    out_uv = uv;
    out_color = color;
    gl_Position = vec4(place * push.ndc_from_points - 1.0, 0.0, 1.0);
}
