#include "sandbox/fly.h"

#include "core/files.h"
#include "sandbox/window.h"

namespace alpenglow {

void set_for_window(Settings& settings) {
    settings.aa = 1;
    settings.post_aa = "fxaa";
    settings.spread_tables = true;
}

int fly(FlyOptions const& options) {
    Flight flight = load_flight(options.flight.value_or(assets_folder() / "flights/valley_to_orbit.json"));
    std::unique_ptr<Window> const window =
        options.headless ? nullptr : Window::open(options.size.value_or(Extent{1280, 720}), "Alpenglow");
    if (window) {
        set_for_window(flight.base.settings);
        fly_in_window(options, flight, *window);
    } else {
        fly_headless(options, flight);
    }
    return 0;
}

} // namespace alpenglow
