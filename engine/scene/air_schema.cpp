#include "scene/air_schema.h"

#include "scene/air.h"
#include "scene/file_keys.h"
#include "scene/schema_parts.h"

namespace alpenglow::schema {

namespace {

using json::NumberKey;

/// An object with a "kind" and these numbers.
Json kind(std::string_view name, std::string const& description, std::vector<NumberKey> const& keys) {
    Json properties{{"kind", {{"enum", Json::array({name})}}}};
    properties.update(numbers(keys));
    std::vector<std::string> required{"kind"};
    for (NumberKey const& key : keys) required.emplace_back(key.name);
    return object(description, std::move(properties), required);
}

Json phase() {
    using namespace json;
    return {{"oneOf",
             {kind(PHASE_KINDS[0], "the same in every direction", {}), kind(PHASE_KINDS[1], "molecules", {}),
              kind(PHASE_KINDS[2], "one lobe", {ASYMMETRY}),
              kind(PHASE_KINDS[3], "two lobes", {ASYMMETRY, SECOND_ASYMMETRY, SECOND_WEIGHT}),
              kind(PHASE_KINDS[4], "dust and haze", {ASYMMETRY}),
              kind(PHASE_KINDS[5], "water droplets, after Jendersie and d'Eon", {DIAMETER})}}};
}

Json table() {
    Json node{{"type", "array"}, {"description", "an altitude in metres, a density"}};
    node["items"] = {{"type", "number"}, {"minimum", 0}, {"maximum", json::NODE_ALTITUDE.largest}};
    node["minItems"] = node["maxItems"] = 2;
    Json properties{{"kind", {{"enum", Json::array({"table"})}}}};
    properties["nodes"] = {
        {"type", "array"},
        {"description", "from the ground up, linear between, 0 outside; two of one altitude make a step"},
        {"items", std::move(node)},
        {"minItems", 2}};
    return object("a table", std::move(properties), {"kind", "nodes"});
}

Json profile() {
    using namespace json;
    return {{"oneOf",
             {kind(PROFILE_KINDS[0], "1 at sea level", {SCALE_HEIGHT}),
              kind(PROFILE_KINDS[1], "1 at its centre", {TENT_CENTRE, TENT_HALF_WIDTH}),
              kind(PROFILE_KINDS[2], "1 between two altitudes", {SHELL_BOTTOM, SHELL_TOP}), table()}}};
}

/// Three coefficients, or an object with one number that they are derived from.
Json coefficients(NumberKey const& law) {
    return {{"oneOf",
             {triple(json::COEFFICIENT, "1/m where the density is 1"),
              object("derived from the wavelengths", numbers(std::span(&law, 1)), {std::string(law.name)})}}};
}

Json component() {
    Json properties{{"name", text("1 to 32 of a to z, 0 to 9 and _; no two are the same")}};
    properties["scattering"] = coefficients(json::AIR_DENSITY);
    properties["absorption"] = coefficients(json::OZONE_COLUMN);
    properties["phase"] = phase();
    properties["profile"] = profile();
    Json component = object("one constituent", std::move(properties), {"name", "profile"});
    component["dependentRequired"] = {{"scattering", {"phase"}}, {"phase", {"scattering"}}};
    return component;
}

} // namespace

Json air() {
    Json properties{{"top_altitude", number(json::TOP_ALTITUDE)}};
    properties["wavelengths"] =
        triple(json::WAVELENGTH, "that coefficients are derived for; 680, 550 and 440 nm where left out");
    properties["components"] = {
        {"type", "array"}, {"items", component()}, {"minItems", 1}, {"maxItems", MOST_AIR_COMPONENTS}};
    return object("left out: no air", std::move(properties), {"top_altitude", "components"});
}

} // namespace alpenglow::schema
