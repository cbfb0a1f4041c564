#pragma once

#include "sandbox/stage.h"

#include <functional>
#include <string>
#include <vector>

namespace alpenglow {

/// A setting that is changed while it flies, as `set_setting` takes it.
struct Switch {
    std::string name, value;
};

/// What is switched, one after the other: quality, model and content of the air, what is shaded, exposure, curve and
/// filter, there and back.
std::vector<Switch> const& measured_switches();

/// Medians over rounds.
struct SwitchTimes {
    double frame_ms = 0;   ///< before
    double longest_ms = 0; ///< longest frame until the air's tables are finished, the one that shows the switch among them
    double shown_ms = 0;   ///< from the switch until its picture is there
    double tables_ms = 0;  ///< and until that is of finished tables
    double after_ms = 0;   ///< a frame, when all is done that is done ahead
};

struct SwitchReport {
    std::string device, driver;
    std::vector<SwitchTimes> times; ///< of measured_switches()
};

/// Makes `measured_switches` while the view's camera looks to and fro, as a window does it (Switches::when_ready): each
/// when all is there that is made ahead. A round begins with a device and a renderer of its own; `before_switch` is called
/// ahead of each switch. Throws Error.
SwitchReport time_switches(DrawOptions const& options, View const& view, Extent size, int rounds,
                           std::function<void()> const& before_switch);

} // namespace alpenglow
