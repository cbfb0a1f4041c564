#pragma once

#include "sandbox/stage.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace alpenglow {

/// Medians over frames that were drawn one after the other.
struct FrameTimes {
    double frame_ms = 0; ///< from the start of a frame's recording to the end of its work on the device
    double cpu_ms = 0;   ///< of that, recording
    std::vector<std::pair<std::string, double>> passes{}; ///< name and time on the device [ms]
    std::vector<std::pair<std::string, double>> tables{}; ///< those that only run when the air changes or the sun moves, all in one frame
};

/// Frames drawn before the measured ones: pipelines are compiled and tables made in the first.
inline constexpr int WARM_UP_FRAMES = 2;
/// Frames behind them that make the air's tables and the shadow ceiling anew.
inline constexpr int TABLE_FRAMES = 3;

/// Draws WARM_UP_FRAMES and TABLE_FRAMES, then `frames` (at least one) that count. `before_frame` is called ahead of each. Throws Error.
FrameTimes time_frames(Stage& stage, View const& view, World const& world, Extent size, int frames,
                       std::function<void()> const& before_frame = {});

} // namespace alpenglow
