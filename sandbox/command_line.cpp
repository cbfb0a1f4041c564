#include "sandbox/command_line.h"

#include "core/error.h"
#include "sandbox/arguments.h"
#include "sandbox/models.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace alpenglow {

namespace {

using Take = std::function<void(std::string const&)>;

/// An option with one value; what follows it on the command line is that value even where it begins with '-', as
/// -45.5,7 does.
CLI::Option* add_value(CLI::App& app, std::string const& name, std::string const& value, Take take,
                       std::string const& help) {
    return app
        .add_option_function<std::vector<std::string>>(
            name,
            [name, take = std::move(take)](std::vector<std::string> const& given) {
                for (std::string const& text : given) {
                    if (text.starts_with("--")) throw Error(ErrorKind::wrong_use, name + " needs a value");
                    take(text);
                }
            },
            help)
        ->expected(1)
        ->allow_extra_args(false)
        ->type_name(value);
}

template <typename Size> void add_size(CLI::App& app, Size& size, std::string const& otherwise = "1280x720") {
    add_value(
        app, "--size", "WxH", [&](std::string const& t) { size = parse_size("--size", t); },
        "pixels; " + otherwise + " unless given");
}

void add_whole(CLI::App& app, std::string const& name, int& value, std::string const& help, int smallest, int largest) {
    add_value(
        app, name, "N",
        [&value, name, smallest, largest](std::string const& t) {
            value = static_cast<int>(parse_integer(name, t, smallest, largest));
        },
        help);
}

void add_frames(CLI::App& app, int& frames, std::string const& help) {
    add_whole(app, "--frames", frames, help, 1, 100'000);
}

void add_path(CLI::App& app, std::string const& name, std::string const& value, std::filesystem::path& path,
              std::string const& help) {
    add_value(
        app, name, value, [&](std::string const& t) { path = t; }, help);
}

void add_views(CLI::App& app, std::vector<std::filesystem::path>& views) {
    app.add_option_function<std::vector<std::string>>(
           "VIEW.json", [&](std::vector<std::string> const& given) { views.assign(given.begin(), given.end()); },
           "view files, JSON")
        ->required()
        ->type_name("FILE");
}

void add_picture(CLI::App& app, std::string const& name, std::filesystem::path& picture, std::string const& help) {
    app.add_option_function<std::string>(
           name, [&](std::string const& given) { picture = given; }, help)
        ->required()
        ->type_name("FILE");
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

void add_overrides(CLI::App& app, std::vector<Override>& overrides) {
    add_value(
        app, "--set", "NAME=VALUE", [&](std::string const& t) { overrides.push_back(parse_override("--set", t)); },
        "a setting, in place of the file's; may be repeated")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_device_options(CLI::App& app, DrawOptions& options) {
    add_value(
        app, "--device", "N",
        [&](std::string const& t) { options.device = static_cast<int>(parse_integer("--device", t, 0, 63)); },
        "device by its number in `alpenglow devices`");
    app.add_flag("--validate", options.validate, "check every Vulkan call; slow");
}

void add_draw_options(CLI::App& app, DrawOptions& options) {
    add_value(
        app, "--planet", "P", [&](std::string const& t) { options.planet = t; }, "name in assets/planets, or a file");
    add_placement(app, options.placement);
    add_overrides(app, options.overrides);
    add_value(
        app, "--show", "NAME",
        [&](std::string const& t) {
            options.overrides.push_back({"show", t});
        },
        "an image of the frame in place of the result");
    add_device_options(app, options);
}

/// An option with one or more values.
void add_list(CLI::App& app, std::string const& name, std::string const& value,
              std::function<void(std::vector<std::string> const&)> take, std::string const& help) {
    app.add_option_function<std::vector<std::string>>(name, std::move(take), help)->expected(1, -1)->type_name(value);
}

void add_optional_path(CLI::App& app, std::string const& name, std::string const& value,
                       std::optional<std::filesystem::path>& path, std::string const& help) {
    add_value(
        app, name, value, [&](std::string const& t) { path = t; }, help);
}

void require_model(std::string const& name) {
    std::string names;
    for (Model const& model : MODELS) {
        if (model.name == name) return;
        names += (names.empty() ? "" : ", ") + std::string(model.name);
    }
    throw Error(ErrorKind::wrong_use, "--model: there is no model '" + name + "'", {}, "the models are: " + names);
}

void add_scene_index(CLI::App& app, std::optional<int>& index) {
    add_value(
        app, "--scene-index", "N",
        [&](std::string const& t) { index = static_cast<int>(parse_integer("--scene-index", t, 0, 1'000'000)); },
        "which of the file's scenes; the file's default unless given");
}

void add_scene_option(CLI::App& app, std::string const& name, DrawOptions& options) {
    add_value(
        app, name, "SCENE", [&](std::string const& t) { options.scene = t; },
        "glTF file, or 'default' for the generated terrain");
    add_scene_index(app, options.scene_index);
}

/// The program's arguments, one subcommand for each command, and what they say.
class Parser {
public:
    Parser() : app_("Alpenglow: from a valley floor to orbit over a glTF terrain.", "alpenglow") {
        app_.set_version_flag("--version", "alpenglow " ALPENGLOW_VERSION);
        app_.require_subcommand(1);
        add_fly();
        add_render();
        add_reference();
        add_terrain();
        add_bench();
        add_compare();
        add_evaluate();
        add_inspect();
        app_.add_subcommand("devices", "Lists the Vulkan devices: which is chosen, which refused, and why")
            ->callback([this] { command_ = DevicesOptions{}; });
    }

    Command parse(std::vector<std::string> arguments) {
        require_known_command(arguments);
        std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
        try {
            app_.parse(std::move(arguments));
        } catch (CLI::CallForHelp const&) {
            return TextToPrint{&chosen() == &app_ ? app_.help() : chosen().help("alpenglow")};
        } catch (CLI::CallForVersion const& version) {
            return TextToPrint{std::string(version.what()) + "\n"};
        } catch (CLI::ParseError const& error) {
            throw Error(ErrorKind::wrong_use, error.what(), {}, "see " + full_name() + " --help");
        }
        return command_;
    }

private:
    CLI::App& chosen() { return app_.get_subcommands().empty() ? app_ : *app_.get_subcommands().front(); }
    std::string full_name() { return &chosen() == &app_ ? "alpenglow" : "alpenglow " + chosen().get_name(); }

    void require_known_command(std::vector<std::string> const& arguments) {
        std::string names;
        for (CLI::App const* const app : app_.get_subcommands({})) {
            names += (names.empty() ? "" : ", ") + app->get_name();
            if (!arguments.empty() && arguments.front() == app->get_name()) return;
        }
        std::string const advice = "the commands are " + names + "; see alpenglow --help";
        if (arguments.empty()) throw Error(ErrorKind::wrong_use, "no command was given", {}, advice);
        if (!arguments.front().starts_with("-")) {
            throw Error(ErrorKind::wrong_use, "there is no command '" + arguments.front() + "'", {}, advice);
        }
    }

    void add_fly() {
        CLI::App& app = *app_.add_subcommand("fly", "Flies: in a window where there is a display, else to pictures");
        add_scene_option(app, "scene", fly_);
        add_value(
            app, "--flight", "F.json", [this](std::string const& t) { fly_.flight = t; },
            "flight file; the default flight unless given");
        app.add_flag("--headless", fly_.headless, "to pictures even where there is a display");
        add_size(app, fly_.size, "1280x720 in a window, 960x540 without,");
        add_frames(app, fly_.frames, "pictures of a headless flight; 24 unless given");
        add_path(app, "--out", "DIR", fly_.out, "folder of a headless flight; out/flight unless given");
        add_draw_options(app, fly_);
        app.callback([this] { command_ = fly_; });
    }

    void add_render() {
        CLI::App& app = *app_.add_subcommand("render", "Renders each view to a picture named after its file");
        add_views(app, render_.views);
        add_scene_option(app, "--scene", render_);
        add_size(app, render_.size);
        add_path(app, "--out", "DIR", render_.out, "folder; out/render unless given");
        add_value(
            app, "--format", "png|exr|png,exr",
            [this](std::string const& t) { set_formats(parse_formats("--format", t)); },
            "png as displayed, exr linear radiance in 32-bit float; png unless given");
        add_draw_options(app, render_);
        app.callback([this] { command_ = render_; });
    }

    void set_formats(PictureFormats formats) { render_.png = formats.png, render_.exr = formats.exr; }

    void add_reference() {
        CLI::App& app = *app_.add_subcommand("reference", "Path-traces each view on the CPU: linear radiance and its "
                                                          "variance as EXR");
        add_views(app, reference_.views);
        add_whole(app, "--samples", reference_.samples, "paths for each pixel, in passes of 256; 4096 unless given", 2, 1 << 30);
        add_value(
            app, "--noise", "X", [this](std::string const& t) { reference_.noise = parse_number("--noise", t, 1e-6, 1); },
            "done when the HDR-FLIP between two halves of the samples is at most this; --samples is then the limit");
        add_value(
            app, "--orders", "K|all",
            [this](std::string const& t) {
                reference_.orders = t == "all" ? 0 : static_cast<int>(parse_integer("--orders", t, 1, 1'000'000));
            },
            "events in air or on ground between sun and camera at most; all unless given");
        add_value(
            app, "--sun", "disc|point",
            [this](std::string const& t) { reference_.point_sun = parse_choice("--sun", t, {"disc", "point"}) == 1; },
            "the light of a disc of the sun's angular radius, or of its centre; disc unless given");
        add_value(
            app, "--seed", "N",
            [this](std::string const& t) {
                reference_.seed = static_cast<std::uint64_t>(parse_integer("--seed", t, 0, 1L << 62));
            },
            "1 unless given; the same picture for any number of threads");
        add_whole(app, "--threads", reference_.threads, "one for each core unless given", 1, 1024);
        add_size(app, reference_.size, "320x180");
        add_path(app, "--out", "DIR", reference_.out, "folder; out/reference unless given");
        app.add_flag("--resume", reference_.resume, "goes on where an interrupted run stopped");
        app.callback([this] { command_ = reference_; });
    }

    void add_terrain() {
        CLI::App& app = *app_.add_subcommand("terrain", "Writes an alpine glTF terrain, the same for the same options");
        TerrainOptions& t = terrain_.terrain;
        constexpr long largest_seed = std::numeric_limits<std::uint32_t>::max();
        add_value(
            app, "--seed", "N",
            [&t](std::string const& s) {
                t.seed = static_cast<std::uint32_t>(parse_integer("--seed", s, 0, largest_seed));
            },
            "1 unless given");
        add_value(
            app, "--side", "KM", [&t](std::string const& s) { t.side_km = parse_number("--side", s, 1, 1000); },
            "side in km; 96 unless given");
        add_value(
            app, "--resolution", "N",
            [&t](std::string const& s) { t.resolution = static_cast<int>(parse_integer("--resolution", s, 64, 8192)); },
            "cells along a side of the eroded height field; 1024 unless given");
        add_value(
            app, "--erosion", "STRENGTH",
            [&t](std::string const& s) { t.erosion = parse_number("--erosion", s, 0, 4); },
            "0 none, 1 alpine; 1 unless given");
        add_path(app, "--out", "FILE", terrain_.out,
                 ".gltf (with its files beside it) or .glb; out/terrain/terrain.gltf unless given");
        app.callback([this] { command_ = terrain_; });
    }

    void add_bench() {
        CLI::App& app = *app_.add_subcommand("bench", "Measures each pass: medians over some frames");
        add_views(app, bench_.views);
        add_scene_option(app, "--scene", bench_);
        add_size(app, bench_.size);
        add_frames(app, bench_.frames, "measured frames, after warm-up; 10 unless given");
        app.add_flag("--json", bench_.json, "prints JSON");
        add_draw_options(app, bench_);
        app.callback([this] { command_ = bench_; });
    }

    void add_compare() {
        CLI::App& app = *app_.add_subcommand("compare", "Measures how far a picture is from its reference");
        add_picture(app, "TEST", compare_.test, "the picture, PNG or EXR by its content");
        add_picture(app, "REFERENCE", compare_.reference, "what it should be, of the same kind and size");
        add_value(
            app, "--exposure", "STOPS",
            [this](std::string const& t) { compare_.exposure = parse_number("--exposure", t, -32, 32); },
            "of EXR pictures as LDR FLIP sees them; 0 unless given");
        add_value(
            app, "--heatmap", "OUT.png", [this](std::string const& t) { compare_.heatmap = t; },
            "a picture of FLIP's error of each pixel");
        app.add_flag("--json", compare_.json, "prints JSON");
        app.callback([this] { command_ = compare_; });
    }

    void add_inspect() {
        CLI::App& app = *app_.add_subcommand("inspect", "Says what a glTF scene holds, and what of it is left out");
        add_picture(app, "SCENE", inspect_.scene, "glTF file");
        add_scene_index(app, inspect_.scene_index);
        app.add_flag("--json", inspect_.json, "prints JSON");
        app.callback([this] { command_ = inspect_; });
    }

    void add_evaluate() {
        CLI::App& app = *app_.add_subcommand("evaluate", "Compares rendered views with the path tracer's pictures");
        EvaluateOptions& e = evaluate_;
        add_list(
            app, "--views", "VIEW.json",
            [&e](std::vector<std::string> const& given) { e.views.assign(given.begin(), given.end()); },
            "view files; all of assets/views/comparison unless given");
        add_list(
            app, "--model", "NAME",
            [&e](std::vector<std::string> const& given) {
                for (std::string const& name : given) require_model(name);
                e.models = given;
            },
            "how the air is lit; all models unless given");
        add_optional_path(app, "--references", "DIR", e.references, "folder; assets/references unless given");
        app.add_flag("--json", e.json, "prints JSON");
        add_optional_path(app, "--heatmaps", "DIR", e.heatmaps, "writes FLIP's heat maps there");
        add_optional_path(app, "--document", "FILE.md", e.document, "writes the table and its worst views as Markdown");
        add_optional_path(app, "--check", "FILE.md", e.check, "fails where FLIP or RMSE are not what that table says");
        add_overrides(app, e.overrides);
        add_device_options(app, e);
        app.callback([this] { command_ = evaluate_; });
    }

    CLI::App app_;
    FlyOptions fly_;
    RenderOptions render_;
    ReferenceOptions reference_;
    TerrainCommandOptions terrain_;
    BenchOptions bench_;
    CompareOptions compare_;
    EvaluateOptions evaluate_;
    InspectOptions inspect_;
    Command command_;
};

/// `--set a=1 b=2` as `--set a=1 --set b=2`.
std::vector<std::string> with_repeated_set(std::span<std::string const> arguments) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        bool const follows_a_setting = result.size() >= 2 && result[result.size() - 2] == "--set";
        if (follows_a_setting && !arguments[i].starts_with("-") && arguments[i].find('=') != std::string::npos) {
            result.push_back("--set");
        }
        result.push_back(arguments[i]);
    }
    return result;
}

void require_gltf_name(std::filesystem::path const& file) {
    if (file.extension() == ".gltf" || file.extension() == ".glb") return;
    throw Error(ErrorKind::wrong_use, "--out '" + file.string() + "' can't be used", {},
                "give a file that ends in .gltf or .glb");
}

} // namespace

Command parse_command_line(std::span<std::string const> arguments) {
    Command const command = Parser().parse(with_repeated_set(arguments));
    if (auto const* const terrain = std::get_if<TerrainCommandOptions>(&command)) require_gltf_name(terrain->out);
    return command;
}

} // namespace alpenglow
