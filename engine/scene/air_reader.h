#pragma once

#include "scene/air.h"
#include "scene/json_reader.h"

namespace alpenglow {

/// The "air" of a planet file. Throws Error(bad_input).
Air read_air(json::Value const& value);

} // namespace alpenglow
