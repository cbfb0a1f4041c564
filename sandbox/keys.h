#pragma once

#include "sandbox/pilot.h"
#include "sandbox/window.h"

#include <span>
#include <string>
#include <vector>

namespace alpenglow {

/// What is on the screen besides the picture, and what the keys have asked for.
struct Screen {
    bool panel = false, help = false;
    bool adapt_share = true;          ///< smaller pictures while they move, on slow devices
    bool save = false;                ///< the picture and its view, at the next chance
    std::vector<std::string> images;  ///< that can be shown in place of the result
    std::string model_limits;         ///< what the model of the air leaves out here
};

struct KeyTarget {
    Pilot& pilot;
    Screen& screen;
};

/// A row of the help. Where there is no action the keys are held or belong to the mouse: `held_input` knows them.
struct KeyRow {
    char const* keys;
    char const* meaning;
    int more = 0, less = 0; ///< keys that give the action +1 and -1
    void (*act)(KeyTarget&, int direction, bool shift) = nullptr;
};

std::span<KeyRow const> key_rows();

/// What each key that was pressed does.
void act_on_keys(KeyTarget target, std::vector<KeyPress> const& pressed);
/// What the keys that are down, or were since the last time, ask of the camera in `dt` [s].
FlyInput held_input(Window const& window, WindowEvents const& events, double dt);

} // namespace alpenglow
