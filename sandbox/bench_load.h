#pragma once

#include "sandbox/commands.h"

namespace alpenglow {

/// Measures and prints how long the scene `options.load`, which is given, takes to load. Returns the exit code. Throws
/// Error.
int bench_load(BenchOptions const& options);

} // namespace alpenglow
