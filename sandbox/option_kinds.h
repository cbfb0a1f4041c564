#pragma once

#include "sandbox/arguments.h"
#include "sandbox/commands.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace alpenglow {

/// Kinds of options that several commands have. Values that can't be used throw Error(wrong_use) while the command line
/// is read.

/// Takes the text of an option's value.
using Take = std::function<void(std::string const&)>;

/// An option with one value; what follows it on the command line is that value even where it begins with '-', as
/// -45.5,7 does.
CLI::Option* add_value(CLI::App& app, std::string const& name, std::string const& value, Take take,
                       std::string const& help);
/// An option with one or more values.
void add_list(CLI::App& app, std::string const& name, std::string const& value,
              std::function<void(std::vector<std::string> const&)> take, std::string const& help);
void add_whole(CLI::App& app, std::string const& name, int& value, std::string const& help, int smallest, int largest);
void add_path(CLI::App& app, std::string const& name, std::string const& value, std::filesystem::path& path,
              std::string const& help);
void add_path(CLI::App& app, std::string const& name, std::string const& value,
              std::optional<std::filesystem::path>& path, std::string const& help);
/// The view files that a command is given, at least one.
CLI::Option* add_views(CLI::App& app, std::vector<std::filesystem::path>& views);
/// `--size`; `otherwise` says the size that is taken without it.
template <typename Size> void add_size(CLI::App& app, Size& size, std::string const& otherwise = "1280x720") {
    add_value(
        app, "--size", "WxH", [&size](std::string const& t) { size = parse_size("--size", t); },
        "pixels; " + otherwise + " unless given");
}
/// `--scene-index`.
void add_scene_index(CLI::App& app, std::optional<int>& index);
/// `--set`.
void add_overrides(CLI::App& app, std::vector<Override>& overrides);
/// `--device` and `--validate`.
void add_device_options(CLI::App& app, DrawOptions& options);

} // namespace alpenglow
