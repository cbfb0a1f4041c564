#pragma once

#include "sandbox/plot.h"
#include "sandbox/shaft_error.h"

namespace alpenglow {

/// Error against cost of brute force with 20 to 800 steps and of the levels, in one view; prints each point.
PlotPanel shaft_panel(Stage& stage, ShaftCase const& given);

/// Throws Error(bad_input) where the file can't be written.
void write_shaft_plot(std::filesystem::path const& file, std::span<PlotPanel const> panels, Extent size,
                      std::string const& device);

} // namespace alpenglow
