#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/exposure.h"

// The exposure that the settings give. One workgroup.
layout(local_size_x = WORKGROUP_SIZE, local_size_y = WORKGROUP_SIZE) in;
layout(binding = EXPOSURE_STATE_SLOT, rgba32f) uniform writeonly image2D state_image;
layout(push_constant, scalar) uniform Push { ExposureState state; };

void main() {
    if (gl_LocalInvocationIndex == 0) imageStore(state_image, ivec2(0), vec4(state.factor, state.stops, state.target, state.metered));
}
