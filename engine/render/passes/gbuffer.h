#pragma once

#include "render/frame.h"

namespace alpenglow {

/// What each pixel sees: the scene's meshes and the planet's body.
GBuffer add_gbuffer(FrameGraph& graph, FrameInputs const& in, ConstantsId frame, int sample);

} // namespace alpenglow
