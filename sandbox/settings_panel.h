#pragma once

#include "core/settings.h"

#include <span>
#include <string>

namespace alpenglow {

/// One ImGui widget for each row of the settings' table, by its type and range, with its help as a tooltip, but for
/// those that `edit_air` is for. `images`: what the setting `show` may name.
void edit_settings(Settings& settings, std::span<std::string const> images);

} // namespace alpenglow
