#include "sandbox/command_line.h"

#include "core/error.h"
#include "sandbox/command_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace alpenglow {

namespace {

/// The program's arguments, one subcommand for each command, and what they say.
class Parser {
public:
    Parser() : app_("Alpenglow: from a valley floor to orbit over a glTF terrain.", "alpenglow") {
        app_.set_version_flag("--version", "alpenglow " ALPENGLOW_VERSION);
        app_.require_subcommand(1);
        add(fly_);
        add(render_);
        add(studio_);
        add(reference_);
        add(terrain_);
        add(scenes_);
        add(bench_);
        add(compare_);
        add(evaluate_);
        add(shafts_);
        add(inspect_);
        add(devices_);
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

    template <typename Options> void add(Options& options) {
        add_command(app_, options).callback([this, &options] { command_ = options; });
    }

    CLI::App app_;
    FlyOptions fly_;
    RenderOptions render_;
    StudioOptions studio_;
    ReferenceOptions reference_;
    TerrainCommandOptions terrain_;
    ScenesOptions scenes_;
    BenchOptions bench_;
    CompareOptions compare_;
    EvaluateOptions evaluate_;
    ShaftsOptions shafts_;
    InspectOptions inspect_;
    DevicesOptions devices_;
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

void require_subject(BenchOptions const& options) {
    if (!options.views.empty() || options.load || options.plot || options.switches) return;
    throw Error(ErrorKind::wrong_use, "VIEW.json, --load, --plot or --switches is required", {},
                "see alpenglow bench --help");
}

} // namespace

Command parse_command_line(std::span<std::string const> arguments) {
    Command const command = Parser().parse(with_repeated_set(arguments));
    if (auto const* const terrain = std::get_if<TerrainCommandOptions>(&command)) require_gltf_name(terrain->out);
    if (auto const* const bench = std::get_if<BenchOptions>(&command)) require_subject(*bench);
    return command;
}

} // namespace alpenglow
