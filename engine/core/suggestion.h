#pragma once

#include <span>
#include <string>
#include <string_view>

namespace alpenglow {

/// "did you mean X?" for the known name with the fewest edits from `name`; empty where nothing comes close (more than
/// two edits in five letters).
std::string suggestion(std::string_view name, std::span<std::string_view const> known);

} // namespace alpenglow
