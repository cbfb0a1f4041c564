#include "sandbox/bench_switches.h"

#include "core/files.h"
#include "core/progress.h"
#include "sandbox/fly.h"
#include "sandbox/switch_times.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

struct ViewSwitches {
    std::string view;
    SwitchReport report;
};

std::string name_of(std::size_t index) {
    Switch const& change = measured_switches()[index];
    return change.name + "=" + change.value;
}

nlohmann::ordered_json json_of(ViewSwitches const& view) {
    nlohmann::ordered_json switches = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < view.report.times.size(); ++i) {
        SwitchTimes const& times = view.report.times[i];
        switches.push_back({{"switch", name_of(i)},
                            {"frame_ms", times.frame_ms},
                            {"longest_ms", times.longest_ms},
                            {"shown_ms", times.shown_ms},
                            {"tables_ms", times.tables_ms},
                            {"after_ms", times.after_ms}});
    }
    return {{"view", view.view}, {"switches", std::move(switches)}};
}

void print_json(Extent size, int rounds, std::vector<ViewSwitches> const& views) {
    nlohmann::ordered_json json{{"device", views.front().report.device},
                                {"driver", views.front().report.driver},
                                {"size", fmt::format("{}x{}", size.width, size.height)},
                                {"rounds", rounds},
                                {"views", nlohmann::ordered_json::array()}};
    for (ViewSwitches const& view : views) json["views"].push_back(json_of(view));
    fmt::print("{}\n", json.dump(2));
}

/// As Markdown: docs/performance.md holds such a table.
void print_table(Extent size, int rounds, ViewSwitches const& view) {
    fmt::print("{}, {}x{}, {} ({}), median of {} rounds, milliseconds:\n\n", view.view, size.width, size.height,
               view.report.device, view.report.driver, rounds);
    fmt::print("| switch | frame before | longest frame | shown after | tables finished after | frame behind it |\n"
               "|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < view.report.times.size(); ++i) {
        SwitchTimes const& times = view.report.times[i];
        fmt::print("| `{}` | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", name_of(i), times.frame_ms,
                   times.longest_ms, times.shown_ms, times.tables_ms, times.after_ms);
    }
}

} // namespace

int bench_switches(BenchOptions const& options) {
    std::vector<std::filesystem::path> files = options.views;
    if (files.empty()) files.push_back(assets_folder() / "views/valley_noon.json");
    std::vector<View> views;
    for (std::filesystem::path const& file : files) views.push_back(load_view(file));

    Extent const size = options.size.value_or(BenchOptions::SWITCHES_SIZE);
    std::size_t done = 0;
    std::size_t const total = views.size() * measured_switches().size() * static_cast<std::size_t>(options.frames);
    Progress progress("measuring", total);
    std::vector<ViewSwitches> times;
    for (View& view : views) {
        set_for_window(view.settings);
        times.push_back({view.name, time_switches(options, view, size, options.frames,
                                                  [&] { progress.update(done++, view.name); })});
    }
    progress.update(total);
    if (options.json) {
        print_json(size, options.frames, times);
    } else {
        for (ViewSwitches const& view : times) print_table(size, options.frames, view);
    }
    return 0;
}

} // namespace alpenglow
