#include "sandbox/arguments.h"
#include "sandbox/command_options.h"
#include "sandbox/option_kinds.h"

#include <limits>

namespace alpenglow {

CLI::App& add_command(CLI::App& program, TerrainCommandOptions& options) {
    CLI::App& app = *program.add_subcommand("terrain", "Writes an alpine glTF terrain, the same for the same options");
    TerrainOptions& t = options.terrain;
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
    add_path(app, "--out", "FILE", options.out,
             ".gltf (with its files beside it) or .glb; out/terrain/terrain.gltf unless given");
    return app;
}

CLI::App& add_command(CLI::App& program, ScenesOptions& options) {
    CLI::App& app = *program.add_subcommand("scenes", "Writes the glTF scenes in which light shafts are measured");
    add_path(app, "--out", "DIR", options.out, "folder; out/scenes unless given");
    return app;
}

CLI::App& add_command(CLI::App& program, InspectOptions& options) {
    CLI::App& app = *program.add_subcommand("inspect", "Says what a glTF scene holds, and what of it is left out");
    app.add_option_function<std::string>(
           "SCENE", [&options](std::string const& given) { options.scene = given; }, "glTF file")
        ->required()
        ->type_name("FILE");
    add_scene_index(app, options.scene_index);
    app.add_flag("--json", options.json, "prints JSON");
    return app;
}

CLI::App& add_command(CLI::App& program, DevicesOptions&) {
    return *program.add_subcommand("devices", "Lists the Vulkan devices: which is chosen, which refused, and why");
}

} // namespace alpenglow
