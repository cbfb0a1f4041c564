#include "sandbox/shaft_plot.h"

#include "core/files.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

namespace {

constexpr int STEPS[] = {20, 50, 100, 200, 400, 800};
constexpr int TIMED_FRAMES = 1; // brute force with 800 steps takes seconds a frame
constexpr double LEAST_FLIP = 1e-4; // so that a picture like the exact one has a place on the axis

PlotPoint measured(Stage& stage, ShaftCase const& given, ShaftLevel const& level, std::string label) {
    ShaftPicture const picture = draw_shafts(stage, given.view, level, given.size, TIMED_FRAMES);
    ShaftError const error = shaft_error(picture.radiance, given);
    double const flip = error.masked_flip.value_or(error.flip);
    fmt::print("{:<16}{:<12}{:>10.1f} ms  masked FLIP {:.5f}\n", given.view.name, level.name, picture.ms, flip);
    return {picture.ms, std::max(flip, LEAST_FLIP), std::move(label)};
}

} // namespace

PlotPanel shaft_panel(Stage& stage, ShaftCase const& given) {
    PlotSeries steps{"even steps", {}};
    for (int const count : STEPS)
        steps.points.push_back(measured(stage, given, even_steps(count), std::to_string(count)));
    PlotPanel panel{given.view.name, {std::move(steps)}};
    for (char const* const name : {"fast", "default"})
        panel.series.push_back({name, {measured(stage, given, {name, {{"shafts", name}}}, "")}});
    return panel;
}

void write_shaft_plot(std::filesystem::path const& file, std::span<PlotPanel const> panels, Extent size,
                      std::string const& device) {
    write_text_file(file, svg_plot(panels, fmt::format("milliseconds of the air, {}x{}, {}", size.width, size.height, device),
                                   "mean HDR FLIP where shafts are"));
}

} // namespace alpenglow
