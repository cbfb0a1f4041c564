#pragma once

#include "sandbox/commands.h"

#include <CLI/CLI.hpp>

namespace alpenglow {

/// Each adds a command with its arguments, which go to `options`: this must live as long as `program` reads.
CLI::App& add_command(CLI::App& program, FlyOptions& options);
CLI::App& add_command(CLI::App& program, RenderOptions& options);
CLI::App& add_command(CLI::App& program, StudioOptions& options);
CLI::App& add_command(CLI::App& program, BenchOptions& options);
CLI::App& add_command(CLI::App& program, ReferenceOptions& options);
CLI::App& add_command(CLI::App& program, CompareOptions& options);
CLI::App& add_command(CLI::App& program, EvaluateOptions& options);
CLI::App& add_command(CLI::App& program, ShaftsOptions& options);
CLI::App& add_command(CLI::App& program, TerrainCommandOptions& options);
CLI::App& add_command(CLI::App& program, ScenesOptions& options);
CLI::App& add_command(CLI::App& program, InspectOptions& options);
CLI::App& add_command(CLI::App& program, DevicesOptions& options);

} // namespace alpenglow
