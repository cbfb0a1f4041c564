#include "core/error.h"
#include "core/files.h"
#include "core/log.h"
#include "core/progress.h"
#include "image/codec.h"
#include "image/color.h"
#include "image/heat_map.h"
#include "render/models/models.h"
#include "sandbox/accuracy_document.h"
#include "sandbox/commands.h"
#include "sandbox/frame_times.h"
#include "sandbox/published_figures.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

constexpr int TIMED_FRAMES = 5;
constexpr std::size_t WORST = 3; // pictures of the document

/// A view with all that its rows need.
struct Case {
    View view;
    ViewReference reference;
};

struct Result {
    Evaluation row;
    View view;
    ViewError error;
    FloatImage reference;
};

std::vector<Case> load_cases(EvaluateOptions const& options, fs::path const& references) {
    std::vector<Case> cases;
    for (fs::path const& file : options.views.empty() ? comparison_views() : options.views) {
        View view = load_view(file);
        view.settings.aa = EVALUATION_AA;
        cases.push_back({std::move(view), load_reference(references, file)});
    }
    return cases;
}

std::vector<std::string> models_of(EvaluateOptions const& options) {
    if (!options.models.empty() && std::ranges::find(options.models, ALL_MODELS) == options.models.end())
        return options.models;
    std::vector<std::string> names;
    for (AirModel const& model : air_models()) names.emplace_back(model.name);
    return names;
}

double time_view(Stage& stage, View view, Extent size) {
    view.settings.aa = 1;
    return time_frames(stage, view, stage.prepare(view), size, TIMED_FRAMES).frame_ms;
}

Result evaluate_case(Stage& stage, Case const& given, std::string const& model) {
    View view = stage.dressed(given.view);
    view.settings.model = model;
    ViewReference const& reference = given.reference;
    ViewError error = measure_error(stage, view, reference);
    double const frame_ms = time_view(stage, view, reference.radiance.extent);
    Evaluation row{view.name,  model,    error.flip,           error.rmse,
                   error.bias, frame_ms, reference.noise_flip, reference.noise_rmse};
    return {std::move(row), std::move(view), std::move(error), reference.radiance};
}

void print_json(std::span<Evaluation const> rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (Evaluation const& row : rows) {
        json.push_back({{"view", row.view},
                        {"model", row.model},
                        {"flip", row.flip},
                        {"rmse", row.rmse},
                        {"bias", row.bias},
                        {"frame_ms", row.frame_ms},
                        {"noise_flip", row.noise_flip},
                        {"noise_rmse", row.noise_rmse}});
    }
    fmt::print("{}\n", json.dump(2));
}

void print_table(std::span<Evaluation const> rows) {
    fmt::print("{:<22}{:<10}{:>9}{:>12}{:>10}{:>9}{:>12}{:>12}{:>10}{:>10}\n", "view", "model", "FLIP", "RMSE", "bias",
               "ms", "noise FLIP", "noise RMSE", "Bruneton", "Hillaire");
    for (Evaluation const& row : rows) {
        fmt::print("{:<22}{:<10}{:>9.5f}{:>12.4e}{:>+8.2f} %{:>9.1f}{:>12.5f}{:>12.1e}", row.view, row.model, row.flip,
                   row.rmse, 100 * row.bias, row.frame_ms, row.noise_flip, row.noise_rmse);
        auto const known = std::ranges::find(PUBLISHED_FIGURES, row.view, &PublishedFigures::view);
        if (known != PUBLISHED_FIGURES.end()) fmt::print("{:>10.3f}{:>10.3f}", known->bruneton, known->hillaire);
        fmt::print("\n");
    }
    fmt::print("\nFLIP is HDR FLIP. {}\n", PUBLISHED_CAVEAT);
}

ByteImage displayed(FloatImage const& radiance, double exposure) {
    return srgb_from_linear(exponential_display(radiance, exposure));
}

/// Rendered, reference and heat map beside each other with 4 black pixels between them, from the top.
ByteImage triptych(Result const& result) {
    double const exposure = result.view.settings.exposure;
    std::array<ByteImage, 3> const parts{displayed(result.error.picture, exposure),
                                         displayed(result.reference, exposure), heat_map(result.error.map)};
    std::uint32_t const width = parts[0].extent.width, stride = width + 4;
    ByteImage picture({2 * stride + width, parts[2].extent.height});
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    for (std::uint32_t part = 0; part < 3; ++part) {
        for (std::uint32_t y = 0; y < parts[part].extent.height; ++y)
            std::copy_n(parts[part].at(0, y), 4 * width, picture.at(part * stride, y));
    }
    return picture;
}

/// With the processor, which on a software device is the device.
std::string device_words(Device const& device) {
    std::string words = fmt::format("{} ({})", device.name(), device.driver());
    std::ifstream cpus("/proc/cpuinfo");
    for (std::string line; std::getline(cpus, line);) {
        if (!line.starts_with("model name")) continue;
        return words + " on " + line.substr(std::min(line.find(':') + 2, line.size()));
    }
    return words;
}

std::string command_words(EvaluateOptions const& options) {
    std::string words = "alpenglow evaluate --document " + options.document->string();
    if (!options.views.empty()) words += " --views";
    for (fs::path const& view : options.views) words += fmt::format(" {}", view.string());
    for (Override const& o : options.overrides) words += fmt::format(" --set {}={}", o.name, o.value);
    return words;
}

void write_document(EvaluateOptions const& options, Device const& device, std::span<Result const> results,
                    std::span<Evaluation const> rows) {
    std::vector<std::string> pictures;
    for (std::size_t const i : worst_rows(rows, WORST)) {
        pictures.push_back(fmt::format("pictures/accuracy_worst_{}.png", pictures.size() + 1));
        write_png(options.document->parent_path() / pictures.back(), triptych(results[i]));
    }
    Extent const size = results.front().reference.extent;
    Circumstances const circumstances{.command = command_words(options),
                                      .device = device_words(device),
                                      .date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now())),
                                      .size = fmt::format("{}x{}", size.width, size.height)};
    write_text_file(*options.document, accuracy_document(rows, circumstances, pictures));
}

void require_recorded(fs::path const& document, std::span<RecordedError const> record, std::span<Evaluation const> rows,
                      bool on_software) {
    std::vector<std::string> differences;
    for (Evaluation const& row : rows) {
        auto const difference = difference_from_record(row, record, record_tolerance(on_software));
        if (difference) differences.push_back(*difference);
    }
    for (std::string const& difference : differences) log_warning(difference);
    if (differences.empty()) return;
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{} of {} rows are not as recorded; {}", differences.size(), rows.size(), differences.front()),
        document.string(), "where the change is meant: alpenglow evaluate --document " + document.string());
}

} // namespace

int evaluate(EvaluateOptions const& options) {
    fs::path const references = options.references.value_or(assets_folder() / "references");
    std::vector<Case> const cases = load_cases(options, references);
    std::vector<std::string> const models = models_of(options);
    std::vector<RecordedError> const record =
        options.check ? recorded_errors(read_text_file(*options.check)) : std::vector<RecordedError>{};
    if (options.heatmaps) require_writable_folder(*options.heatmaps);
    if (options.document) require_writable_folder(options.document->parent_path() / "pictures");

    Stage stage(options);
    std::vector<Result> results;
    Progress progress("evaluating", cases.size() * models.size());
    for (Case const& given : cases) {
        for (std::string const& model : models) {
            progress.update(results.size(), given.view.name);
            results.push_back(evaluate_case(stage, given, model));
        }
    }
    progress.update(results.size());
    stage.require_no_messages();

    std::vector<Evaluation> rows;
    for (Result const& result : results) {
        rows.push_back(result.row);
        fs::path const name = fmt::format("{}_{}.png", result.row.view, result.row.model);
        if (options.heatmaps) write_png(*options.heatmaps / name, heat_map(result.error.map));
    }
    if (options.document) write_document(options, stage.device(), results, rows);
    if (options.json)
        print_json(rows);
    else
        print_table(rows);
    if (options.check) require_recorded(*options.check, record, rows, stage.device().is_software());
    return 0;
}

} // namespace alpenglow
