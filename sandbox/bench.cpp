#include "core/progress.h"
#include "sandbox/bench_load.h"
#include "sandbox/bench_switches.h"
#include "sandbox/commands.h"
#include "sandbox/cost_plot.h"
#include "sandbox/frame_times.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

struct ViewTimes {
    std::string view;
    FrameTimes times;
    double peak_mib = 0;
};

ViewTimes measure(Stage& stage, View const& view, BenchOptions const& options, Progress& progress, std::size_t& done) {
    Extent const size = options.size.value_or(BenchOptions::SIZE);
    World const world = stage.prepare(view);
    FrameTimes const times = time_frames(stage, view, world, size, options.frames,
                                         [&] { progress.update(done++, view.name); });
    return {view.name, times, static_cast<double>(stage.device().peak_memory()) / (1 << 20)};
}

nlohmann::ordered_json passes_json(std::vector<std::pair<std::string, double>> const& passes) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (auto const& [name, ms] : passes) json.push_back({{"name", name}, {"gpu_ms", ms}});
    return json;
}

void print_json(Stage const& stage, Extent size, std::vector<ViewTimes> const& views) {
    nlohmann::ordered_json json{{"device", stage.device().name()},
                                {"driver", stage.device().driver()},
                                {"size", fmt::format("{}x{}", size.width, size.height)},
                                {"views", nlohmann::ordered_json::array()}};
    for (ViewTimes const& view : views) {
        json["views"].push_back({{"view", view.view},
                                 {"frame_ms", view.times.frame_ms},
                                 {"cpu_ms", view.times.cpu_ms},
                                 {"peak_mib", view.peak_mib},
                                 {"passes", passes_json(view.times.passes)},
                                 {"tables", passes_json(view.times.tables)}});
    }
    fmt::print("{}\n", json.dump(2));
}

void print_passes(std::vector<std::pair<std::string, double>> const& passes) {
    for (auto const& [name, ms] : passes) fmt::print("  {:<22} {:9.3f} ms\n", name, ms);
}

void print_table(Stage const& stage, Extent size, int frames, std::vector<ViewTimes> const& views) {
    fmt::print("{} ({}), {}x{}, median of {} frames\n", stage.device().name(), stage.device().driver(), size.width,
               size.height, frames);
    for (ViewTimes const& view : views) {
        fmt::print("{}: {:.1f} ms a frame, {:.2f} ms of it on the CPU, device memory at most {:.0f} MiB\n", view.view,
                   view.times.frame_ms, view.times.cpu_ms, view.peak_mib);
        print_passes(view.times.passes);
        if (view.times.tables.empty()) continue;
        double all = 0;
        for (auto const& [name, ms] : view.times.tables) all += ms;
        fmt::print("  when the air changes (terrain_above: the scene; other maps of terrain: also when the sun moves), made at once: {:.1f} ms\n", all);
        print_passes(view.times.tables);
    }
}

int bench_views(BenchOptions const& options) {
    std::vector<View> views;
    for (std::filesystem::path const& file : options.views) views.push_back(load_view(file));
    Stage stage(options);
    std::size_t done = 0;
    std::size_t const total = views.size() * static_cast<std::size_t>(WARM_UP_FRAMES + TABLE_FRAMES + options.frames);
    Progress progress("measuring", total);
    std::vector<ViewTimes> times;
    for (View const& view : views) times.push_back(measure(stage, stage.dressed(view), options, progress, done));
    progress.update(total);
    stage.require_no_messages();
    Extent const size = options.size.value_or(BenchOptions::SIZE);
    if (options.json)
        print_json(stage, size, times);
    else
        print_table(stage, size, options.frames, times);
    return 0;
}

} // namespace

int bench(BenchOptions const& options) {
    if (options.load) return bench_load(options);
    if (options.switches) return bench_switches(options);
    if (!options.plot) return bench_views(options);
    plot_costs(options);
    return 0;
}

} // namespace alpenglow
