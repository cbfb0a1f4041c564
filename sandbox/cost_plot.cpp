#include "sandbox/cost_plot.h"

#include "core/files.h"
#include "core/progress.h"
#include "render/models/models.h"
#include "sandbox/evaluation.h"
#include "sandbox/frame_times.h"
#include "sandbox/plot.h"

#include <fmt/format.h>

namespace alpenglow {

namespace {

/// From the ground, inside the air and from orbit.
constexpr std::array DEFAULT_VIEWS{"ground-sunrise", "terrain-12km", "orbit-sunrise"};

/// The samples at which a model is measured; its price for the largest stays bearable.
std::vector<int> samples_of(std::string_view model) {
    if (model == "tables") return {32}; // doesn't depend on them
    if (model == "naive") return {4, 8, 16, 32};
    return {4, 8, 16, 32, 64};
}

/// A model of the air with settings of its own.
struct Curve {
    std::string name;
    std::string_view model;
    bool shafts = true; ///< as the view has them; off otherwise
};

/// All models, and of `march` over a scene also without shafts, as `tables` draws it.
std::vector<Curve> curves_of(View const& view) {
    std::vector<Curve> curves;
    for (AirModel const& model : air_models()) curves.push_back({std::string(model.name), model.name});
    if (!view.scene.empty()) curves.push_back({"march, no shafts", "march", false});
    return curves;
}

struct PlotCase {
    View view;
    ViewReference reference;
};

std::vector<PlotCase> load_cases(BenchOptions const& options) {
    std::vector<std::filesystem::path> files = options.views;
    if (files.empty()) {
        for (char const* const name : DEFAULT_VIEWS)
            files.push_back(assets_folder() / "views/comparison" / (std::string(name) + ".json"));
    }
    std::vector<PlotCase> cases;
    for (std::filesystem::path const& file : files)
        cases.push_back({load_view(file), load_reference(assets_folder() / "references", file)});
    return cases;
}

PlotPoint measure_point(Stage& stage, PlotCase const& given, BenchOptions const& options, Curve const& curve,
                        int samples) {
    View view = stage.dressed(given.view);
    view.settings.model = curve.model;
    if (!curve.shafts) view.settings.shafts = "off";
    view.settings.samples = samples;
    view.settings.aa = 1;
    Extent const size = options.size.value_or(BenchOptions::SIZE);
    double const ms = time_frames(stage, view, stage.prepare(view), size, options.frames).frame_ms;
    view.settings.aa = EVALUATION_AA;
    double const flip = measure_error(stage, view, given.reference).flip;
    std::string const count = samples_of(curve.model).size() > 1 ? std::to_string(samples) : std::string();
    fmt::print("{:<18}{:<18}{:>4}{:>12.1f} ms  FLIP {:.5f}\n", view.name, curve.name, count, ms, flip);
    return {ms, flip, count};
}

} // namespace

void plot_costs(BenchOptions const& options) {
    std::vector<PlotCase> const cases = load_cases(options);
    require_writable_folder(options.plot->parent_path());
    Stage stage(options);
    std::vector<PlotPanel> panels;
    for (PlotCase const& given : cases) {
        PlotPanel& panel = panels.emplace_back(PlotPanel{given.view.name, {}});
        for (Curve const& curve : curves_of(given.view)) {
            PlotSeries& series = panel.series.emplace_back(PlotSeries{curve.name, {}});
            for (int const samples : samples_of(curve.model))
                series.points.push_back(measure_point(stage, given, options, curve, samples));
        }
    }
    stage.require_no_messages();
    Extent const size = options.size.value_or(BenchOptions::SIZE);
    write_text_file(*options.plot, svg_plot(panels,
                                            fmt::format("milliseconds of a frame of {}x{}, {}", size.width, size.height,
                                                        stage.device().name()),
                                            "mean HDR FLIP against the path tracer"));
}

} // namespace alpenglow
