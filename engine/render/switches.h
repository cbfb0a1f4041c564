#pragma once

#include "core/settings.h"

#include <vector>

namespace alpenglow {

/// Whether they agree in all that is switched on and off or chosen from a list.
bool same_choices(Settings const& a, Settings const& b);

/// All settings that differ from these in one switch or one choice: where the next click in a panel leads. All show
/// the result: an image that is shown in its place is not there with every model.
std::vector<Settings> one_choice_away(Settings const& settings);

} // namespace alpenglow
