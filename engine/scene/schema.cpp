#include "scene/schema.h"

#include "core/settings.h"
#include "scene/file_keys.h"

#include <span>
#include <vector>

namespace alpenglow {

namespace {

using Json = nlohmann::ordered_json;
using json::NumberKey;

Json text_schema(std::string const& description) { return {{"type", "string"}, {"description", description}}; }

Json number_schema(NumberKey const& key) {
    Json schema{{"type", "number"}, {"description", key.help}};
    schema[key.above_smallest ? "exclusiveMinimum" : "minimum"] = key.smallest;
    schema["maximum"] = key.largest;
    if (key.fallback) schema["default"] = *key.fallback;
    return schema;
}

Json triple_schema(NumberKey const& key, std::string const& description) {
    NumberKey channel = key;
    channel.help = "of red, green, blue";
    return {{"type", "array"},
            {"description", description},
            {"items", number_schema(channel)},
            {"minItems", 3},
            {"maxItems", 3}};
}

Json object_schema(std::string const& description, Json properties, std::vector<std::string> const& required) {
    Json schema{{"type", "object"}, {"description", description}, {"additionalProperties", false}};
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = required;
    return schema;
}

Json numbers_schema(std::span<NumberKey const> keys) {
    Json properties = Json::object();
    for (NumberKey const& key : keys) properties[std::string(key.name)] = number_schema(key);
    return properties;
}

std::vector<std::string> required_names(std::span<NumberKey const> keys) {
    std::vector<std::string> names;
    for (NumberKey const& key : keys) {
        if (!key.fallback) names.emplace_back(key.name);
    }
    return names;
}

std::string file_text(std::string const& title, Json const& schema) {
    Json file{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
    file.update(schema);
    return file.dump(2) + "\n";
}

Json choices_schema(SettingInfo const& info, bool whole) {
    Json choices = Json::array();
    for (std::string_view rest = info.choices; !rest.empty();) {
        std::string const choice(rest.substr(0, rest.find('|')));
        choices.push_back(whole ? Json(std::stoi(choice)) : Json(choice));
        rest.remove_prefix(std::min(choice.size() + 1, rest.size()));
    }
    return choices;
}

Json setting_schema(SettingInfo const& info) {
    constexpr std::string_view TYPES[] = {"boolean", "integer", "number", "string"};
    bool const whole = info.member.index() == 1;
    Json schema{{"type", TYPES[info.member.index()]}};
    schema["description"] = std::string(info.help) + (info.unit.empty() ? "" : " [" + std::string(info.unit) + "]");
    if (!info.choices.empty())
        schema["enum"] = choices_schema(info, whole);
    else if (whole)
        schema["minimum"] = static_cast<int>(info.smallest), schema["maximum"] = static_cast<int>(info.largest);
    else if (info.member.index() == 2)
        schema["minimum"] = info.smallest, schema["maximum"] = info.largest;
    std::visit([&](auto const& plain) { schema["default"] = plain; }, get_setting(Settings{}, info));
    return schema;
}

Json scene_schema() {
    std::vector<NumberKey> const keys{json::LATITUDE, json::LONGITUDE, json::ANCHOR_ALTITUDE, json::YAW, json::SCALE};
    Json properties{{"file", text_schema("as the text above")}};
    properties["index"] = number_schema(json::SCENE_INDEX);
    properties["index"]["type"] = "integer";
    properties.update(numbers_schema(keys));
    properties["curve"] = {
        {"type", "boolean"}, {"default", false}, {"description", "bend a scene made for a flat map to the planet"}};
    Json placed = object_schema("a scene and where it stands", std::move(properties), {"file"});
    placed["dependentRequired"] = {{"latitude", {"longitude"}}, {"longitude", {"latitude"}}, {"altitude", {"latitude"}},
                                   {"yaw", {"latitude"}},       {"scale", {"latitude"}},     {"curve", {"latitude"}}};
    return {
        {"oneOf",
         {text_schema("path of a glTF file from this file's folder; \"default\": the generated terrain; empty: none"),
          std::move(placed)}}};
}

Json sun_schema() {
    std::vector<NumberKey> const keys{json::ELEVATION, json::AZIMUTH};
    Json const utc = text_schema("a time from 1900 to 2100 like 2026-06-21T04:30:00Z");
    return {{"oneOf",
             {object_schema("in the sky over the scene's anchor (the camera's ground point without a scene)",
                            numbers_schema(keys), required_names(keys)),
              object_schema("where it stands at a time over Earth", {{"utc", utc}}, {"utc"})}}};
}

Json camera_schema() {
    return object_schema("where the camera stands and looks", numbers_schema(json::CAMERA_KEYS),
                         required_names(json::CAMERA_KEYS));
}

Json base_view_properties() {
    Json properties{
        {"$schema", text_schema("this schema, for editors")},
        {"description", text_schema("for people")},
        {"planet", text_schema("a name from assets/planets, or a path from this file's folder; earth where left out")},
        {"scene", scene_schema()},
        {"sun", sun_schema()}};
    for (SettingInfo const& info : setting_table()) properties[std::string(info.name)] = setting_schema(info);
    return properties;
}

Json air_schema() {
    Json rayleigh{{"scattering", triple_schema(json::COEFFICIENT, "1/m at sea level")}};
    rayleigh["scale_height"] = number_schema(json::SCALE_HEIGHT);
    Json aerosol = rayleigh;
    aerosol["extinction"] = triple_schema(json::COEFFICIENT, "1/m at sea level, at least the scattering");
    aerosol["g"] = number_schema(json::ASYMMETRY);
    Json ozone{{"absorption", triple_schema(json::COEFFICIENT, "1/m at the tent's peak")}};
    ozone["centre"] = number_schema(json::OZONE_CENTRE);
    ozone["half_width"] = number_schema(json::OZONE_HALF_WIDTH);
    Json properties{{"top_altitude", number_schema(json::TOP_ALTITUDE)}};
    properties["rayleigh"] = object_schema("molecules", std::move(rayleigh), {"scattering", "scale_height"});
    properties["aerosol"] =
        object_schema("dust and haze", std::move(aerosol), {"scattering", "extinction", "scale_height", "g"});
    properties["ozone"] =
        object_schema("a tent of absorption", std::move(ozone), {"absorption", "centre", "half_width"});
    return object_schema("left out: no air", std::move(properties), {"top_altitude", "rayleigh"});
}

} // namespace

std::string planet_schema_text() {
    Json ground{{"look", {{"type", "string"}, {"enum", {"uniform", "procedural"}}}}};
    ground["albedo"] =
        triple_schema(json::ALBEDO, "mean of the ground; where the look is uniform, of a matte ground all round");
    Json sun{{"irradiance", triple_schema(json::IRRADIANCE, "above the air, relative")}};
    sun["angular_radius"] = number_schema(json::SUN_RADIUS);
    Json properties{{"$schema", text_schema("this schema, for editors")},
                    {"name", text_schema("for messages and pictures")},
                    {"source", text_schema("where the numbers come from")},
                    {"radius", number_schema(json::RADIUS)},
                    {"air", air_schema()}};
    properties["ground"] = object_schema("the planet's own surface", std::move(ground), {"look", "albedo"});
    properties["sun"] = object_schema("its star", std::move(sun), {"irradiance", "angular_radius"});
    return file_text("Alpenglow planet", object_schema("SI units; angles in degrees", std::move(properties),
                                                       {"name", "source", "radius", "ground", "sun"}));
}

std::string view_schema_text() {
    Json properties = base_view_properties();
    Json const name = text_schema("name of a camera in the scene's file; `alpenglow inspect` lists them");
    properties["camera"] = {
        {"oneOf", {camera_schema(), object_schema("the scene's own camera", {{"gltf", name}}, {"gltf"})}}};
    return file_text("Alpenglow view",
                     object_schema("one picture: SI units, angles in degrees", std::move(properties), {"camera"}));
}

std::string flight_schema_text() {
    Json key{{"time", number_schema(json::TIME)}, {"camera", camera_schema()}, {"sun", sun_schema()}};
    key["exposure"] = setting_schema(*find_setting("exposure"));
    // What a key leaves out is as in the key before it.
    key["exposure"].erase("default");
    key["camera"]["properties"]["fov"].erase("default");
    Json properties = base_view_properties();
    properties["ground"] = number_schema(json::GROUND);
    properties["keys"] = {{"type", "array"},
                          {"minItems", 2},
                          {"description", "in order of time, the first at 0; what one leaves out is as before"},
                          {"items", object_schema("a view at a time", std::move(key), {"time", "camera"})}};
    return file_text("Alpenglow flight",
                     object_schema("timed views: SI units, angles in degrees", std::move(properties), {"keys"}));
}

} // namespace alpenglow
