#pragma once

#include "render/models/model.h"

#include <set>
#include <span>

namespace alpenglow {

/// All models of the air, the default first: the one list of them.
std::span<AirModel const> air_models();

/// Throws Error(wrong_use) where there is none of that name.
AirModel const& air_model(std::string_view name);

/// Names of all passes that make tables which outlive the frame, of any model.
std::set<std::string> const& table_passes();

/// What the model in the settings leaves out or can't do in this world, in a sentence that begins with its name; empty
/// where it applies in full or there is no air. `meshes`: the world has some. Throws as `air_model`.
std::string model_limits(World const& world, Settings const& settings, bool meshes);

} // namespace alpenglow
