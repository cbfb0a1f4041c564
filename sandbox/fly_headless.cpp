#include "sandbox/fly.h"

#include "core/files.h"
#include "core/progress.h"
#include "image/codec.h"
#include "image/contact_sheet.h"
#include "sandbox/stage.h"

#include <cmath>
#include <fmt/format.h>

namespace alpenglow {

namespace {

std::string altitude_text(double metres) {
    return metres < 10000 ? fmt::format("{:.0f} m", metres) : fmt::format("{:.0f} km", metres / 1000);
}

} // namespace

void fly_headless(FlyOptions const& options, Flight const& flight) {
    require_writable_folder(options.out);
    Stage stage(options);
    Extent const size = options.size.value_or(Extent{960, 540});
    ContactSheet sheet(static_cast<std::size_t>(options.frames), size);
    Progress progress("flying", static_cast<std::size_t>(options.frames));
    for (int i = 0; i < options.frames; ++i) {
        double const time = options.frames > 1 ? flight.duration() * i / (options.frames - 1) : 0.0;
        View const view = stage.dressed(flight.at(time));
        std::string const altitude = altitude_text(view.camera.place.altitude);
        progress.update(static_cast<std::size_t>(i), altitude);
        World const world = stage.prepare(view);
        if (i > 0) stage.renderer().pass_time(flight.duration() / (options.frames - 1));
        stage.draw(view, world, size);
        ByteImage const picture = stage.renderer().picture();
        write_png(options.out / fmt::format("frame_{:04}.png", i), picture);
        sheet.add(picture, fmt::format("{:.1f} s  {}", time, altitude));
    }
    write_png(options.out / "contact_sheet.png", sheet.picture());
    progress.update(static_cast<std::size_t>(options.frames));
    stage.require_no_messages();
    fmt::print("{}\n", (options.out / "contact_sheet.png").string());
}

} // namespace alpenglow
