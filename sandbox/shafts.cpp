#include "core/files.h"
#include "core/progress.h"
#include "image/codec.h"
#include "image/heat_map.h"
#include "image/mask.h"
#include "sandbox/commands.h"
#include "sandbox/shaft_error.h"
#include "sandbox/shaft_plot.h"
#include "sandbox/shaft_table.h"

#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>

namespace alpenglow {

namespace fs = std::filesystem;

namespace {

constexpr int TIMED_FRAMES = 3;

ShaftRow row_of(ShaftCase const& given, ShaftLevel const& level, ShaftError const& error, double ms) {
    return {given.view.name,   level.name, share_of(given.mask), error.flip,
            error.masked_flip, error.rmse, error.p999,           ms};
}

/// The levels of one view, exact ones last.
void measure_view(Stage& stage, ShaftCase const& given, ShaftsOptions const& options, std::vector<ShaftRow>& rows) {
    for (ShaftLevel const& level : shaft_levels()) {
        ShaftPicture const picture = draw_shafts(stage, given.view, level, given.size, TIMED_FRAMES);
        ShaftError const error = shaft_error(picture.radiance, given);
        rows.push_back(row_of(given, level, error, picture.ms));
        fs::path const name = fmt::format("{}_{}.png", given.view.name, level.name);
        if (options.heatmaps) write_png(*options.heatmaps / name, heat_map(error.map));
    }
    rows.push_back(row_of(given, exact_shafts(), shaft_error(given.exact.radiance, given), given.exact.ms));
}

std::string introduction(ShaftsOptions const& options, Device const& device) {
    std::string words = "alpenglow shafts";
    for (fs::path const& view : options.views) words += fmt::format(" {}", view.string());
    for (Override const& o : options.overrides) words += fmt::format(" --set {}={}", o.name, o.value);
    return fmt::format("`{} --document {}`, {:%Y-%m-%d}, {} ({}), {}x{}.\n", words, options.document->string(),
                       fmt::gmtime(std::chrono::system_clock::now()), device.name(), device.driver(),
                       options.size.width, options.size.height);
}

void write_document(ShaftsOptions const& options, Device const& device, std::span<ShaftRow const> rows) {
    std::string const section = shaft_markdown(introduction(options, device), rows);
    std::string const page = read_text_file(*options.document);
    write_text_file(*options.document, with_shaft_section(page, section, options.document->string()));
}

} // namespace

int shafts(ShaftsOptions const& options) {
    std::vector<View> views;
    for (fs::path const& file : options.views.empty() ? shaft_views() : options.views) views.push_back(load_view(file));
    if (options.heatmaps) require_writable_folder(*options.heatmaps);
    if (options.plot) require_writable_folder(options.plot->parent_path());
    if (options.document) with_shaft_section(read_text_file(*options.document), {}, options.document->string());

    Stage stage(options);
    std::vector<ShaftRow> rows;
    std::vector<PlotPanel> panels;
    Progress progress("measuring", views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        progress.update(i, views[i].name);
        ShaftCase const given = make_shaft_case(stage, stage.dressed(views[i]), options.size);
        if (options.plot)
            panels.push_back(shaft_panel(stage, given));
        else
            measure_view(stage, given, options, rows);
    }
    progress.update(views.size());
    stage.require_no_messages();

    if (options.plot) {
        write_shaft_plot(*options.plot, panels, options.size, stage.device().name());
        return 0;
    }
    if (options.document) write_document(options, stage.device(), rows);
    fmt::print("{}", options.json ? shaft_json(rows) : shaft_text(rows));
    return 0;
}

} // namespace alpenglow
