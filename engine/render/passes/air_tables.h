#pragma once

#include "render/frame.h"

namespace alpenglow {

/// The tables of the air, made anew where they are stale: optical depth, light of higher orders, the sky's irradiance.
AirTables add_air_tables(FrameGraph& graph, FrameInputs const& in, ConstantsId frame);

} // namespace alpenglow
