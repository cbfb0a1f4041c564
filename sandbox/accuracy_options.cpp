#include "core/error.h"
#include "core/settings.h"
#include "sandbox/arguments.h"
#include "sandbox/command_options.h"
#include "sandbox/option_kinds.h"

namespace alpenglow {

namespace {

void add_picture(CLI::App& app, std::string const& name, std::filesystem::path& picture, std::string const& help) {
    app.add_option_function<std::string>(
           name, [&](std::string const& given) { picture = given; }, help)
        ->required()
        ->type_name("FILE");
}

void require_model(std::string const& name) {
    SettingInfo const& info = *find_setting("model");
    if (name == ALL_MODELS || in_range(info, name)) return;
    throw Error(ErrorKind::wrong_use, "--model: there is no model '" + name + "'", {},
                "give all, or some of " + range_text(info));
}

} // namespace

CLI::App& add_command(CLI::App& program, ReferenceOptions& options) {
    CLI::App& app = *program.add_subcommand("reference", "Path-traces each view on the CPU: linear radiance and its "
                                                      "variance as EXR");
    add_views(app, options.views);
    add_whole(app, "--samples", options.samples,
              "paths for each pixel, in passes of 256, two at least; 4096 unless given", 2, 1 << 30);
    add_value(
        app, "--noise", "X", [&options](std::string const& t) { options.noise = parse_number("--noise", t, 1e-6, 1); },
        "done when the HDR-FLIP between two halves of the samples is at most this; --samples is then the limit");
    add_value(
        app, "--orders", "K|all",
        [&options](std::string const& t) {
            options.orders = t == "all" ? 0 : static_cast<int>(parse_integer("--orders", t, 1, 1'000'000));
        },
        "events in air or on ground between sun and camera at most; all unless given");
    add_value(
        app, "--sun", "disc|point",
        [&options](std::string const& t) { options.point_sun = parse_choice("--sun", t, {"disc", "point"}) == 1; },
        "the light of a disc of the sun's angular radius, or of its centre; disc unless given");
    add_value(
        app, "--seed", "N",
        [&options](std::string const& t) {
            options.seed = static_cast<std::uint64_t>(parse_integer("--seed", t, 0, 1L << 62));
        },
        "1 unless given; the same picture for any number of threads");
    add_whole(app, "--threads", options.threads, "one for each core unless given", 1, 1024);
    add_size(app, options.size, "320x180");
    add_path(app, "--out", "DIR", options.out, "folder; out/reference unless given");
    app.add_flag("--resume", options.resume, "goes on where an interrupted run stopped; finished pictures stay");
    return app;
}

CLI::App& add_command(CLI::App& program, CompareOptions& options) {
    CLI::App& app = *program.add_subcommand("compare", "Measures how far a picture is from its reference");
    add_picture(app, "TEST", options.test, "the picture, PNG or EXR by its content");
    add_picture(app, "REFERENCE", options.reference, "what it should be, of the same kind and size");
    add_value(
        app, "--exposure", "STOPS",
        [&options](std::string const& t) { options.exposure = parse_number("--exposure", t, -32, 32); },
        "of EXR pictures as LDR FLIP sees them; 0 unless given");
    add_value(
        app, "--heatmap", "OUT.png", [&options](std::string const& t) { options.heatmap = t; },
        "a picture of FLIP's error of each pixel");
    app.add_flag("--json", options.json, "prints JSON");
    return app;
}

CLI::App& add_command(CLI::App& program, EvaluateOptions& options) {
    CLI::App& app = *program.add_subcommand("evaluate", "Compares rendered views with the path tracer's pictures");
    add_list(
        app, "--views", "VIEW.json",
        [&options](std::vector<std::string> const& given) { options.views.assign(given.begin(), given.end()); },
        "view files; all of assets/views/comparison unless given");
    add_list(
        app, "--model", "NAME",
        [&options](std::vector<std::string> const& given) {
            for (std::string const& name : given) require_model(name);
            options.models = given;
        },
        "models of the air, or all; all unless given");
    add_path(app, "--references", "DIR", options.references, "folder; assets/references unless given");
    app.add_flag("--json", options.json, "prints JSON");
    add_path(app, "--heatmaps", "DIR", options.heatmaps, "writes FLIP's heat maps there");
    add_path(app, "--document", "FILE.md", options.document, "writes the table and its worst views as Markdown");
    add_path(app, "--check", "FILE.md", options.check, "fails where FLIP or RMSE are not what that table says");
    add_overrides(app, options.overrides);
    add_device_options(app, options);
    return app;
}

CLI::App& add_command(CLI::App& program, ShaftsOptions& options) {
    CLI::App& app = *program.add_subcommand("shafts", "Measures each quality of light shafts against exact ones");
    app.add_option_function<std::vector<std::string>>(
           "VIEW", [&options](std::vector<std::string> const& given) { options.views.assign(given.begin(), given.end()); },
           "view files; all of assets/views/shafts unless given")
        ->type_name("VIEW.json ...");
    add_size(app, options.size, "640x360");
    app.add_flag("--json", options.json, "prints JSON");
    add_path(app, "--heatmaps", "DIR", options.heatmaps, "writes FLIP's heat maps there");
    add_path(app, "--document", "FILE.md", options.document, "writes the table into its section of that page");
    add_path(app, "--plot", "FILE.svg", options.plot, "writes error against cost, even steps beside the levels");
    add_overrides(app, options.overrides);
    add_device_options(app, options);
    return app;
}

} // namespace alpenglow
