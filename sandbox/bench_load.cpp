#include "sandbox/bench_load.h"

#include "core/progress.h"
#include "sandbox/bench_scene.h"
#include "sandbox/load_times.h"
#include "sandbox/stage.h"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace {

struct Row {
    char const *key, *title;
    LoadTimes::Step LoadTimes::*step;
};

constexpr std::array ROWS{Row{"read_and_decode", "reading and decoding alone", &LoadTimes::read_and_decode},
                          Row{"load", "loading", &LoadTimes::load},
                          Row{"load_and_upload", "loading and upload", &LoadTimes::load_and_upload}};

double wall_ratio(LoadTimes const& times, Row const& row) {
    return (times.*row.step).wall_ms / times.read_and_decode.wall_ms;
}
double cpu_ratio(LoadTimes const& times, Row const& row) {
    return (times.*row.step).cpu_ms / times.read_and_decode.cpu_ms;
}

void print_json(Device const& device, std::string const& scene, int rounds, LoadTimes const& times) {
    nlohmann::ordered_json json{{"device", device.name()},           {"driver", device.driver()}, {"scene", scene},
                                {"triangles", times.triangles},      {"pictures", times.pictures}, {"rounds", rounds}};
    for (Row const& row : ROWS) {
        json[row.key] = {{"wall_ms", (times.*row.step).wall_ms},
                         {"cpu_ms", (times.*row.step).cpu_ms},
                         {"wall_ratio", wall_ratio(times, row)},
                         {"cpu_ratio", cpu_ratio(times, row)}};
    }
    fmt::print("{}\n", json.dump(2));
}

void print_table(Device const& device, std::string const& scene, int rounds, LoadTimes const& times) {
    fmt::print("{}: {} triangles, {} pictures; {} ({}), median of {} rounds\n", scene, times.triangles, times.pictures,
               device.name(), device.driver(), rounds);
    for (Row const& row : ROWS) {
        fmt::print("  {:<26} {:9.1f} ms, {:9.1f} ms of CPU; {:.2f} and {:.2f} times the first\n", row.title,
                   (times.*row.step).wall_ms, (times.*row.step).cpu_ms, wall_ratio(times, row), cpu_ratio(times, row));
    }
}

} // namespace

int bench_load(BenchOptions const& options) {
    Stage stage(options);
    std::optional<BenchScene> made;
    if (options.load->empty()) made.emplace();
    std::filesystem::path const file = made ? made->file() : *options.load;
    std::string const name = made ? "a scene made for this" : file.string();

    std::size_t done = 0;
    Progress progress("measuring", static_cast<std::size_t>(LOAD_WARM_UP_ROUNDS + options.frames));
    View const view = stage.dressed({});
    LoadTimes const times =
        time_loading(stage.device(), file, view, options.frames, [&] { progress.update(done++); });
    progress.update(done);
    stage.require_no_messages();
    if (options.json)
        print_json(stage.device(), name, options.frames, times);
    else
        print_table(stage.device(), name, options.frames, times);
    return 0;
}

} // namespace alpenglow
