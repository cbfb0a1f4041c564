#include "scene/air_reader.h"

#include "scene/file_keys.h"
#include "scene/spectrum.h"

#include <algorithm>
#include <fmt/format.h>

namespace alpenglow {

namespace {

using json::Object;
using json::Value;

constexpr std::size_t LONGEST_NAME = 32;
constexpr std::string_view NAME_CHARACTERS = "abcdefghijklmnopqrstuvwxyz0123456789_";

/// What the coefficients of a component may depend on.
struct Derivation {
    double top_altitude; ///< [m]
    glm::dvec3 wavelengths;
};

std::string read_name(Value const& value, Air const& air) {
    std::string const name = value.text();
    if (name.empty() || name.size() > LONGEST_NAME || name.find_first_not_of(NAME_CHARACTERS) != std::string::npos)
        value.refuse(value.quoted() + " is no name for a component",
                     fmt::format("give 1 to {} of a to z, 0 to 9 and _", LONGEST_NAME));
    if (std::ranges::find(air.components, name, &AirComponent::name) != air.components.end())
        value.refuse("there are two components " + value.quoted(), "give each another name");
    return name;
}

Phase read_phase(Value const& value) {
    Object const all = value.object({"kind", "g", "second_g", "second_weight", "diameter"});
    Value const named = all.at("kind");
    std::string const kind = named.text();
    auto const with = [&](std::vector<std::string_view> keys) {
        keys.insert(keys.begin(), "kind");
        return value.object(keys);
    };
    if (kind == "isotropic") return with({}), Phase{};
    if (kind == "rayleigh") return with({}), Phase{.kind = Phase::Kind::rayleigh};
    if (kind == "henyey_greenstein")
        return {.kind = Phase::Kind::henyey_greenstein, .g = with({"g"}).number(json::ASYMMETRY)};
    if (kind == "cornette_shanks")
        return {.kind = Phase::Kind::cornette_shanks, .g = with({"g"}).number(json::ASYMMETRY)};
    if (kind == "droplets")
        return {.kind = Phase::Kind::droplets, .diameter = with({"diameter"}).number(json::DIAMETER)};
    if (kind == "double_henyey_greenstein") {
        Object const lobes = with({"g", "second_g", "second_weight"});
        return {.kind = Phase::Kind::double_henyey_greenstein,
                .g = lobes.number(json::ASYMMETRY),
                .second_g = lobes.number(json::SECOND_ASYMMETRY),
                .second_weight = lobes.number(json::SECOND_WEIGHT)};
    }
    named.refuse("there is no phase " + named.quoted(),
                 fmt::format("give one of {}", fmt::join(json::PHASE_KINDS, ", ")));
}

LinearProfile read_table(Value const& value) {
    LinearProfile table;
    for (Value const& node : value.list()) {
        std::vector<Value> const pair = node.list();
        if (pair.size() != 2) node.refuse("a node has two numbers", "give [altitude in metres, density]");
        table.nodes.push_back({pair[0].number(json::NODE_ALTITUDE), pair[1].number(json::NODE_DENSITY)});
        if (std::size_t const n = table.nodes.size();
            n > 1 && table.nodes[n - 1].altitude < table.nodes[n - 2].altitude)
            pair[0].refuse("the altitude is below the one before", "sort the nodes from the ground up");
    }
    if (table.nodes.size() < 2) value.refuse("a table has two nodes at least", "add [altitude in metres, density]");
    return table;
}

LinearProfile read_shell(Value const& value) {
    Object const shell = value.object({"kind", "bottom", "top"});
    double const bottom = shell.number(json::SHELL_BOTTOM), top = shell.number(json::SHELL_TOP);
    if (top <= bottom) shell.at("top").refuse("the shell's top is not above its bottom", "give a higher altitude");
    return shell_profile(bottom, top);
}

Profile read_profile(Value const& value) {
    Object const all = value.object({"kind", "scale_height", "centre", "half_width", "bottom", "top", "nodes"});
    Value const named = all.at("kind");
    std::string const kind = named.text();
    if (kind == "exponential")
        return ExponentialProfile{value.object({"kind", "scale_height"}).number(json::SCALE_HEIGHT)};
    if (kind == "tent") {
        Object const tent = value.object({"kind", "centre", "half_width"});
        return tent_profile(tent.number(json::TENT_CENTRE), tent.number(json::TENT_HALF_WIDTH));
    }
    if (kind == "shell") return read_shell(value);
    if (kind == "table") return read_table(value.object({"kind", "nodes"}).at("nodes"));
    named.refuse("there is no profile " + named.quoted(),
                 fmt::format("give one of {}", fmt::join(json::PROFILE_KINDS, ", ")));
}

glm::dvec3 read_scattering(Value const& value, Derivation const& from) {
    if (!value.json().is_object()) return value.triple(json::COEFFICIENT);
    return value.object({"air_density"}).number(json::AIR_DENSITY) * rayleigh_scattering(from.wavelengths);
}

glm::dvec3 read_absorption(Value const& value, Derivation const& from, Profile const& profile) {
    if (!value.json().is_object()) return value.triple(json::COEFFICIENT);
    double const units = value.object({"ozone_column"}).number(json::OZONE_COLUMN);
    double const column = profile_column(profile, from.top_altitude);
    if (!(column > 0)) value.refuse("the profile is empty", "a column needs somewhere to be");
    return ozone_absorption(units, column, from.wavelengths);
}

AirComponent read_component(Value const& value, Air const& air, Derivation const& from) {
    Object const object = value.object({"name", "scattering", "absorption", "phase", "profile"});
    AirComponent component;
    component.name = read_name(object.at("name"), air);
    component.profile = read_profile(object.at("profile"));
    if (object.has("scattering")) {
        component.scattering = read_scattering(object.at("scattering"), from);
        component.phase = read_phase(object.at("phase"));
    } else if (object.has("phase")) {
        object.at("phase").refuse("a phase is for what scatters", "add \"scattering\", or remove it");
    }
    if (object.has("absorption"))
        component.absorption = read_absorption(object.at("absorption"), from, component.profile);
    return component;
}

void require_room(Value const& value, Air const& air) {
    std::size_t pieces = 0;
    for (AirComponent const& component : air.components) pieces += piece_count(component.profile);
    if (pieces > MOST_PROFILE_PIECES)
        value.refuse(
            fmt::format("the tents, shells and tables have {} pieces", pieces),
            fmt::format("there is room for {}: two for a tent or a shell, one between two nodes of a table and "
                        "one at each end that is not 0",
                        MOST_PROFILE_PIECES));
}

} // namespace

Air read_air(Value const& value) {
    Object const object = value.object({"top_altitude", "wavelengths", "components"});
    Air air;
    air.top_altitude = object.number(json::TOP_ALTITUDE);
    Derivation from{air.top_altitude, CANONICAL_WAVELENGTHS};
    if (object.has("wavelengths")) from.wavelengths = object.at("wavelengths").triple(json::WAVELENGTH);
    Value const components = object.at("components");
    std::vector<Value> const list = components.list();
    if (list.empty() || list.size() > MOST_AIR_COMPONENTS)
        components.refuse(fmt::format("the air has {} components", list.size()),
                          fmt::format("give 1 to {}, or no air", MOST_AIR_COMPONENTS));
    for (Value const& component : list) air.components.push_back(read_component(component, air, from));
    require_room(components, air);
    return air;
}

} // namespace alpenglow
