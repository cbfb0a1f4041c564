#include "sandbox/fly.h"

#include "core/files.h"
#include "sandbox/window.h"

namespace alpenglow {

namespace {

/// A window wants many pictures a second: edges are smoothed by the post filter, unless `--set aa=4` says otherwise, and no
/// frame waits for tables.
Flight for_a_window(Flight flight) {
    flight.base.settings.aa = 1;
    flight.base.settings.post_aa = "fxaa";
    flight.base.settings.spread_tables = true;
    return flight;
}

} // namespace

int fly(FlyOptions const& options) {
    Flight const flight = load_flight(options.flight.value_or(assets_folder() / "flights/valley_to_orbit.json"));
    std::unique_ptr<Window> const window =
        options.headless ? nullptr : Window::open(options.size.value_or(Extent{1280, 720}), "Alpenglow");
    if (window) {
        fly_in_window(options, for_a_window(flight), *window);
    } else {
        fly_headless(options, flight);
    }
    return 0;
}

} // namespace alpenglow
