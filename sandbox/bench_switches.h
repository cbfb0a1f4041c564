#pragma once

#include "sandbox/commands.h"

namespace alpenglow {

/// Measures and prints what switches of settings cost while it flies, in each of `options.views`. Returns the exit code.
/// Throws Error.
int bench_switches(BenchOptions const& options);

} // namespace alpenglow
