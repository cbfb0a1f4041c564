#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The tables of the frame's model of the air; those that outlive the frame are made anew where they are stale.
AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame);

} // namespace alpenglow
