#pragma once

#include "scene/air.h"
#include "scene/json_reader.h"

#include <span>
#include <string>
#include <string_view>

namespace alpenglow {

/// A phase as the setting `air_phases` writes it: its kind, then its numbers, colons between them, such as
/// "henyey_greenstein:0.76" or "droplets:2e-05".
std::string phase_text(Phase const& phase);
/// The other way. Throws Error(bad_input).
Phase phase_from_text(std::string_view text);

/// The numbers that follow a kind, and where a phase has them.
std::span<json::NumberKey const> phase_numbers(Phase::Kind kind);
double& phase_number(Phase& phase, json::NumberKey const& key);

/// The air with changes that are made while it runs: `without` names components that are left out (switched off),
/// `phases` gives others than the planet's, as NAME=PHASE; commas between several. Throws Error(bad_input), for a name
/// that the air does not have among others.
Air changed_air(Air air, std::string_view without, std::string_view phases);
/// The other way: what `without` and `phases` must say for the planet's air to become `changed`.
std::string names_switched_off(Air const& changed);
std::string phases_beside(Air const& planet_air, Air const& changed);

} // namespace alpenglow
