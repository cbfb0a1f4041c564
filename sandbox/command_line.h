#pragma once

#include "sandbox/commands.h"

#include <span>
#include <string>
#include <variant>

namespace alpenglow {

/// What `--help` and `--version` ask for: text for stdout.
struct TextToPrint {
    std::string text;
};

using Command =
    std::variant<TextToPrint, FlyOptions, RenderOptions, StudioOptions, ReferenceOptions, CompareOptions,
                 EvaluateOptions, ShaftsOptions, TerrainCommandOptions, ScenesOptions, BenchOptions, InspectOptions,
                 DevicesOptions>;

/// `arguments` without the program's name. Throws Error(wrong_use), one line with what is wrong and what to do. Whether
/// the settings of `--set` exist is for apply_overrides to say.
Command parse_command_line(std::span<std::string const> arguments);

} // namespace alpenglow
