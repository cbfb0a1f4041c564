#pragma once

#include "sandbox/commands.h"
#include "scene/view.h"

namespace alpenglow {

class Window;

/// A window wants many pictures a second: edges are smoothed by the post filter, unless `--set aa=4` says otherwise, and
/// no frame waits for tables.
void set_for_window(Settings& settings);

/// The two ways of `fly`. Both throw Error.

/// To pictures and a contact sheet in options.out.
void fly_headless(FlyOptions const& options, Flight const& flight);
/// In the window, until it is closed; the user takes over at the first key or move of the mouse.
void fly_in_window(FlyOptions const& options, Flight const& flight, Window& window);

} // namespace alpenglow
