#include "core/settings.h"
#include "sandbox/arguments.h"
#include "sandbox/command_options.h"
#include "sandbox/option_kinds.h"

#include <cmath>

namespace alpenglow {

namespace {

void add_frames(CLI::App& app, int& frames, std::string const& help) {
    add_whole(app, "--frames", frames, help, 1, 100'000);
}

void add_placement(CLI::App& app, PlacementOptions& placement) {
    add_value(
        app, "--at", "LAT,LON[,ALT]", [&](std::string const& t) { placement.at = parse_place("--at", t); },
        "where the scene's origin stands [degrees, metres]");
    add_value(
        app, "--yaw", "DEGREES",
        [&](std::string const& t) { placement.yaw = parse_number("--yaw", t, -360, 360) * M_PI / 180; },
        "turns the scene clockwise seen from above");
    add_value(
        app, "--scale", "FACTOR",
        [&](std::string const& t) { placement.scale = parse_number("--scale", t, 1e-6, 1e6); }, "scales the scene");
    app.add_flag("--curve", placement.curve, "bends a terrain made for a flat map to the planet");
}

void add_draw_options(CLI::App& app, DrawOptions& options) {
    add_value(
        app, "--planet", "P", [&](std::string const& t) { options.planet = t; }, "name in assets/planets, or a file");
    add_placement(app, options.placement);
    add_overrides(app, options.overrides);
    add_value(
        app, "--model", "NAME",
        [&](std::string const& t) {
            options.overrides.push_back({"model", t});
        },
        "how the air is lit: " + range_text(*find_setting("model")));
    add_value(
        app, "--show", "NAME",
        [&](std::string const& t) {
            options.overrides.push_back({"show", t});
        },
        "an image of the frame in place of the result");
    add_device_options(app, options);
}

void add_scene_option(CLI::App& app, std::string const& name, DrawOptions& options) {
    add_value(
        app, name, "SCENE", [&](std::string const& t) { options.scene = t; },
        "glTF file, or 'default' for the generated terrain");
    add_scene_index(app, options.scene_index);
}

/// Excludes what is only for pictures; all that must have been added before.
void add_load(CLI::App& app, std::optional<std::filesystem::path>& load) {
    app.add_option_function<std::vector<std::string>>(
           "--load",
           [&load](std::vector<std::string> const& given) { load = given.empty() ? std::string() : given.front(); },
           "measures how long a glTF file takes to load, in place of views; without a file, one of 500 000 triangles "
           "with eight pictures of 2048x2048 that is made for it")
        ->expected(0, 1)
        ->type_name("[SCENE]")
        ->excludes("VIEW.json", "--scene", "--size", "--planet", "--at", "--yaw", "--scale", "--curve", "--show",
                   "--plot", "--switches");
}

} // namespace

CLI::App& add_command(CLI::App& program, FlyOptions& options) {
    CLI::App& app = *program.add_subcommand("fly", "Flies: in a window where there is a display, else to pictures");
    add_scene_option(app, "scene", options);
    add_value(
        app, "--flight", "F.json", [&options](std::string const& t) { options.flight = t; },
        "flight file; the default flight unless given");
    app.add_flag("--headless", options.headless, "to pictures even where there is a display");
    add_size(app, options.size, "1280x720 in a window, 960x540 without,");
    add_frames(app, options.frames, "pictures of a headless flight; 24 unless given");
    add_path(app, "--out", "DIR", options.out, "folder of a headless flight; out/flight unless given");
    add_draw_options(app, options);
    return app;
}

CLI::App& add_command(CLI::App& program, RenderOptions& options) {
    CLI::App& app = *program.add_subcommand("render", "Renders each view to a picture named after its file, and several onto a contact sheet too");
    add_views(app, options.views);
    add_scene_option(app, "--scene", options);
    add_size(app, options.size);
    add_path(app, "--out", "DIR", options.out, "folder; out/render unless given");
    add_value(
        app, "--format", "png|exr|png,exr",
        [&options](std::string const& t) {
            PictureFormats const formats = parse_formats("--format", t);
            options.png = formats.png, options.exr = formats.exr;
        },
        "png as displayed, exr linear radiance in 32-bit float; png unless given");
    add_draw_options(app, options);
    return app;
}

CLI::App& add_command(CLI::App& program, StudioOptions& options) {
    CLI::App& app = *program.add_subcommand(
        "studio", "Draws each scene by itself, in even light and without a planet, on one sheet");
    app.add_option_function<std::vector<std::string>>(
           "SCENE",
           [&options](std::vector<std::string> const& given) { options.scenes.assign(given.begin(), given.end()); },
           "glTF files, or folders of them")
        ->required()
        ->type_name("FILE");
    add_scene_index(app, options.scene_index);
    add_size(app, options.size, "each scene's picture; 320x320");
    add_path(app, "--out", "FILE.png", options.out, "the sheet; out/studio.png unless given");
    add_overrides(app, options.overrides);
    add_device_options(app, options);
    return app;
}

CLI::App& add_command(CLI::App& program, BenchOptions& options) {
    CLI::App& app = *program.add_subcommand("bench", "Measures each pass, loading or switches: medians over some frames");
    add_views(app, options.views)->required(false);
    add_scene_option(app, "--scene", options);
    add_size(app, options.size, "1280x720, or 320x180 for --switches,");
    add_frames(app, options.frames,
               "measured frames, after warm-up, or rounds of --load and --switches; 10 unless given");
    app.add_flag("--json", options.json, "prints JSON");
    add_path(app, "--plot", "FILE.svg", options.plot,
             "draws each model's error against its cost instead, in three comparison views unless some are given");
    add_draw_options(app, options);
    app.add_flag("--switches", options.switches,
                 "measures how long changes of settings take while it flies instead, in valley_noon unless views are given")
        ->excludes("--plot");
    add_load(app, options.load);
    return app;
}

} // namespace alpenglow
