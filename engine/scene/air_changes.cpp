#include "scene/air_changes.h"

#include "core/error.h"
#include "core/suggestion.h"
#include "scene/file_keys.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using json::NumberKey;

constexpr NumberKey LOBE[] = {json::ASYMMETRY};
constexpr NumberKey TWO_LOBES[] = {json::ASYMMETRY, json::SECOND_ASYMMETRY, json::SECOND_WEIGHT};
constexpr NumberKey DROPLETS[] = {json::DIAMETER};

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        std::size_t const end = std::min(text.find(separator), text.size());
        parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

[[noreturn]] void refuse(std::string const& setting, std::string const& what, std::string const& advice) {
    throw Error(ErrorKind::bad_input, what, "setting " + setting, advice);
}

double read_number(std::string_view text, NumberKey const& key) {
    double number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    // Written so that NaN is refused too.
    if (error == std::errc{} && end == text.data() + text.size() && number >= key.smallest && number <= key.largest)
        return number;
    refuse("air_phases", fmt::format("\"{}\" is no {}", text, key.name),
           fmt::format("give {}, {} to {}", key.help, key.smallest, key.largest));
}

std::size_t require_component(Air const& air, std::string const& setting, std::string_view name) {
    auto const found = std::ranges::find(air.components, name, &AirComponent::name);
    if (found != air.components.end()) return static_cast<std::size_t>(found - air.components.begin());
    std::vector<std::string_view> names;
    for (AirComponent const& component : air.components) names.push_back(component.name);
    std::string advice = suggestion(std::string(name), names);
    if (advice.empty()) advice = names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", "));
    refuse(setting, fmt::format("the planet's air has no component \"{}\"", name), advice);
}

} // namespace

std::span<NumberKey const> phase_numbers(Phase::Kind kind) {
    switch (kind) {
    case Phase::Kind::henyey_greenstein:
    case Phase::Kind::cornette_shanks:
        return LOBE;
    case Phase::Kind::double_henyey_greenstein:
        return TWO_LOBES;
    case Phase::Kind::droplets:
        return DROPLETS;
    case Phase::Kind::isotropic:
    case Phase::Kind::rayleigh:
        break;
    }
    return {};
}

double& phase_number(Phase& phase, NumberKey const& key) {
    if (key.name == json::SECOND_ASYMMETRY.name) return phase.second_g;
    if (key.name == json::SECOND_WEIGHT.name) return phase.second_weight;
    return key.name == json::DIAMETER.name ? phase.diameter : phase.g;
}

std::string phase_text(Phase const& phase) {
    std::string text(json::PHASE_KINDS[static_cast<std::size_t>(phase.kind)]);
    Phase copy = phase;
    for (NumberKey const& key : phase_numbers(phase.kind)) text += fmt::format(":{}", phase_number(copy, key));
    return text;
}

Phase phase_from_text(std::string_view text) {
    std::vector<std::string_view> const parts = split(text, ':');
    auto const kind = std::ranges::find(json::PHASE_KINDS, parts.empty() ? std::string_view() : parts.front());
    if (kind == json::PHASE_KINDS.end())
        refuse("air_phases", fmt::format("there is no phase \"{}\"", text),
               fmt::format("give one of {}", fmt::join(json::PHASE_KINDS, ", ")));
    Phase phase{.kind = static_cast<Phase::Kind>(kind - json::PHASE_KINDS.begin())};
    std::span<NumberKey const> const keys = phase_numbers(phase.kind);
    if (parts.size() != keys.size() + 1)
        refuse("air_phases", fmt::format("\"{}\" has {} numbers", text, parts.size() - 1),
               fmt::format("{} has {}, with colons between", *kind, keys.size()));
    for (std::size_t i = 0; i < keys.size(); ++i) phase_number(phase, keys[i]) = read_number(parts[i + 1], keys[i]);
    return phase;
}

Air changed_air(Air air, std::string_view without, std::string_view phases) {
    for (std::string_view const change : split(phases, ',')) {
        std::size_t const equals = change.find('=');
        if (equals == std::string_view::npos)
            refuse("air_phases", fmt::format("\"{}\" has no =", change), "give COMPONENT=PHASE");
        std::size_t const place = require_component(air, "air_phases", change.substr(0, equals));
        air.components[place].phase = phase_from_text(change.substr(equals + 1));
    }
    for (std::string_view const name : split(without, ','))
        air.components[require_component(air, "air_without", name)].on = false;
    return air;
}

std::string names_switched_off(Air const& changed) {
    std::vector<std::string> names;
    for (AirComponent const& component : changed.components)
        if (!component.on) names.push_back(component.name);
    return fmt::format("{}", fmt::join(names, ","));
}

std::string phases_beside(Air const& planet_air, Air const& changed) {
    std::vector<std::string> changes;
    for (std::size_t i = 0; i < changed.components.size(); ++i) {
        std::string const text = phase_text(changed.components[i].phase);
        if (text != phase_text(planet_air.components[i].phase))
            changes.push_back(changed.components[i].name + "=" + text);
    }
    return fmt::format("{}", fmt::join(changes, ","));
}

} // namespace alpenglow
