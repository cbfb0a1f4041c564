#include "core/progress.h"
#include "sandbox/commands.h"
#include "sandbox/stage.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

constexpr int WARM_UP = 2; // frames: pipelines are compiled and tables made in the first

struct PassSamples {
    std::string name;
    std::vector<double> gpu_ms;
};

struct ViewTimes {
    std::string view;
    double frame_ms = 0, cpu_ms = 0;
    double peak_mib = 0;
    std::vector<std::pair<std::string, double>> passes;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    std::size_t const middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

void note_passes(std::vector<PassSamples>& passes, std::vector<PassTime> const& times) {
    for (PassTime const& time : times) {
        auto entry = std::ranges::find(passes, time.name, &PassSamples::name);
        if (entry == passes.end()) entry = passes.insert(passes.end(), {time.name, {}});
        entry->gpu_ms.push_back(time.gpu_ms);
    }
}

double sum(std::vector<PassTime> const& times, double PassTime::*member) {
    double total = 0;
    for (PassTime const& time : times) total += time.*member;
    return total;
}

ViewTimes measure(Stage& stage, View const& view, BenchOptions const& options, Progress& progress, std::size_t& done) {
    World const world = stage.prepare(view);
    std::vector<double> frame, cpu;
    std::vector<PassSamples> passes;
    for (int i = 0; i < WARM_UP + options.frames; ++i) {
        progress.update(done++, view.name);
        auto const start = std::chrono::steady_clock::now();
        stage.draw(view, world, options.size);
        stage.renderer().wait();
        double const elapsed =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        if (i < WARM_UP) continue;
        std::vector<PassTime> const& times = stage.renderer().timings();
        frame.push_back(elapsed);
        cpu.push_back(sum(times, &PassTime::cpu_ms));
        note_passes(passes, times);
    }
    ViewTimes result{
        view.name, median(frame), median(cpu), static_cast<double>(stage.device().peak_memory()) / (1 << 20), {}};
    for (PassSamples const& pass : passes) result.passes.emplace_back(pass.name, median(pass.gpu_ms));
    return result;
}

void print_json(Stage const& stage, Extent size, std::vector<ViewTimes> const& views) {
    nlohmann::ordered_json json{{"device", stage.device().name()},
                                {"driver", stage.device().driver()},
                                {"size", fmt::format("{}x{}", size.width, size.height)},
                                {"views", nlohmann::ordered_json::array()}};
    for (ViewTimes const& view : views) {
        nlohmann::ordered_json passes = nlohmann::ordered_json::array();
        for (auto const& [name, ms] : view.passes) passes.push_back({{"name", name}, {"gpu_ms", ms}});
        json["views"].push_back({{"view", view.view},
                                 {"frame_ms", view.frame_ms},
                                 {"cpu_ms", view.cpu_ms},
                                 {"peak_mib", view.peak_mib},
                                 {"passes", passes}});
    }
    fmt::print("{}\n", json.dump(2));
}

void print_table(Stage const& stage, BenchOptions const& options, std::vector<ViewTimes> const& views) {
    fmt::print("{} ({}), {}x{}, median of {} frames\n", stage.device().name(), stage.device().driver(),
               options.size.width, options.size.height, options.frames);
    for (ViewTimes const& view : views) {
        fmt::print("{}: {:.1f} ms a frame, {:.2f} ms of it on the CPU, device memory at most {:.0f} MiB\n", view.view,
                   view.frame_ms, view.cpu_ms, view.peak_mib);
        for (auto const& [name, ms] : view.passes) fmt::print("  {:<22} {:9.3f} ms\n", name, ms);
    }
}

} // namespace

int bench(BenchOptions const& options) {
    std::vector<View> views;
    for (std::filesystem::path const& file : options.views) views.push_back(load_view(file));
    Stage stage(options);
    std::size_t done = 0;
    std::size_t const total = views.size() * static_cast<std::size_t>(WARM_UP + options.frames);
    Progress progress("measuring", total);
    std::vector<ViewTimes> times;
    for (View const& view : views) times.push_back(measure(stage, stage.dressed(view), options, progress, done));
    progress.update(total);
    stage.require_no_messages();
    if (options.json)
        print_json(stage, options.size, times);
    else
        print_table(stage, options, times);
    return 0;
}

} // namespace alpenglow
