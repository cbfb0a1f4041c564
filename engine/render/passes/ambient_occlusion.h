#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The share of the light from all round that reaches each pixel's surface past what the picture shows near it, 0 to 1.
/// 1 everywhere where the setting `ambient_occlusion` is off.
ImageId add_ambient_occlusion(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, GBuffer const& gbuffer,
                              WorkListId pixels, ImageId terrain_light, int sample);

} // namespace alpenglow
