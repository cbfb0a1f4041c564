#pragma once

#include "sandbox/commands.h"

namespace alpenglow {

/// Measures each model's error against what a frame costs, at several numbers of samples where these matter, and writes
/// the curves to `options.plot` as SVG. Throws Error.
void plot_costs(BenchOptions const& options);

} // namespace alpenglow
