#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/display.h"

// Fast approximate antialiasing on the encoded picture, after Lottes (2009): blends along edges of luma found in the
// four diagonal neighbours.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = POST_AA_PICTURE_SLOT) uniform sampler2D picture;
layout(binding = POST_AA_RESULT_SLOT, rgba8) uniform writeonly image2D result;

const float EDGE_SHARE = 1.0 / 8.0; // of the brightest neighbour, below which an edge is left alone
const float EDGE_LEAST = 1.0 / 32.0;
const float LONGEST = 8.0;          // [pixel]

float luma(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 step = 1.0 / vec2(size);
    vec2 at = (vec2(pixel) + 0.5) * step;
    vec3 centre = textureLod(picture, at, 0.0).rgb;
    float nw = luma(textureLod(picture, at + vec2(-1, -1) * step, 0.0).rgb);
    float ne = luma(textureLod(picture, at + vec2(1, -1) * step, 0.0).rgb);
    float sw = luma(textureLod(picture, at + vec2(-1, 1) * step, 0.0).rgb);
    float se = luma(textureLod(picture, at + vec2(1, 1) * step, 0.0).rgb);
    float m = luma(centre);
    float lowest = min(m, min(min(nw, ne), min(sw, se))), highest = max(m, max(max(nw, ne), max(sw, se)));
    bool edge = highest - lowest > max(EDGE_LEAST, highest * EDGE_SHARE);

    vec2 along = vec2(-((nw + ne) - (sw + se)), (nw + sw) - (ne + se));
    float damp = max((nw + ne + sw + se) * (0.25 / 8.0), 1.0 / 128.0);
    along = clamp(along / (min(abs(along.x), abs(along.y)) + damp), -LONGEST, LONGEST) * step;
    vec3 near = 0.5 * (textureLod(picture, at - along / 6.0, 0.0).rgb + textureLod(picture, at + along / 6.0, 0.0).rgb);
    vec3 far = 0.5 * near + 0.25 * (textureLod(picture, at - along * 0.5, 0.0).rgb + textureLod(picture, at + along * 0.5, 0.0).rgb);
    float far_luma = luma(far);
    vec3 blended = far_luma < lowest || far_luma > highest ? near : far;
    imageStore(result, pixel, vec4(edge ? blended : centre, 1.0));
}
