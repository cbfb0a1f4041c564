#include "scene/schema.h"

#include "core/settings.h"
#include "scene/air_schema.h"
#include "scene/file_keys.h"
#include "scene/schema_parts.h"

#include <span>
#include <vector>

namespace alpenglow {

namespace {

using namespace schema;
using json::NumberKey;

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
    Json properties{{"file", text("as the text above")}};
    properties["index"] = number(json::SCENE_INDEX);
    properties["index"]["type"] = "integer";
    properties.update(numbers(keys));
    properties["curve"] = {
        {"type", "boolean"}, {"default", false}, {"description", "bend a scene made for a flat map to the planet"}};
    Json placed = object("a scene and where it stands", std::move(properties), {"file"});
    placed["dependentRequired"] = {{"latitude", {"longitude"}}, {"longitude", {"latitude"}}, {"altitude", {"latitude"}},
                                   {"yaw", {"latitude"}},       {"scale", {"latitude"}},     {"curve", {"latitude"}}};
    return {
        {"oneOf",
         {text("path of a glTF file from this file's folder; \"default\": the generated terrain; empty: none"),
          std::move(placed)}}};
}

Json sun_schema() {
    std::vector<NumberKey> const keys{json::ELEVATION, json::AZIMUTH};
    Json const utc = text("a time from 1900 to 2100 like 2026-06-21T04:30:00Z");
    return {{"oneOf",
             {object("in the sky over the scene's anchor (the camera's ground point without a scene)",
                            numbers(keys), required_names(keys)),
              object("where it stands at a time over Earth", {{"utc", utc}}, {"utc"})}}};
}

Json camera_schema() {
    return object("where the camera stands and looks", numbers(json::CAMERA_KEYS),
                         required_names(json::CAMERA_KEYS));
}

Json base_view_properties() {
    Json properties{
        {"$schema", text("this schema, for editors")},
        {"description", text("for people")},
        {"planet", text("a name from assets/planets, or a path from this file's folder; earth where left out")},
        {"scene", scene_schema()},
        {"sun", sun_schema()}};
    for (SettingInfo const& info : setting_table()) properties[std::string(info.name)] = setting_schema(info);
    return properties;
}

} // namespace

std::string planet_schema_text() {
    Json ground{{"look", {{"type", "string"}, {"enum", {"uniform", "procedural"}}}}};
    ground["albedo"] =
        triple(json::ALBEDO, "mean of the ground; where the look is uniform, of a matte ground all round");
    Json sun{{"irradiance", triple(json::IRRADIANCE, "above the air, relative")}};
    sun["angular_radius"] = number(json::SUN_RADIUS);
    Json properties{{"$schema", text("this schema, for editors")},
                    {"name", text("for messages and pictures")},
                    {"source", text("where the numbers come from")},
                    {"radius", number(json::RADIUS)},
                    {"air", schema::air()}};
    properties["ground"] = object("the planet's own surface", std::move(ground), {"look", "albedo"});
    properties["sun"] = object("its star", std::move(sun), {"irradiance", "angular_radius"});
    return file_text("Alpenglow planet", object("SI units; angles in degrees", std::move(properties),
                                                       {"name", "source", "radius", "ground", "sun"}));
}

std::string view_schema_text() {
    Json properties = base_view_properties();
    Json const name = text("name of a camera in the scene's file; `alpenglow inspect` lists them");
    properties["camera"] = {
        {"oneOf", {camera_schema(), object("the scene's own camera", {{"gltf", name}}, {"gltf"})}}};
    return file_text("Alpenglow view",
                     object("one picture: SI units, angles in degrees", std::move(properties), {"camera"}));
}

std::string flight_schema_text() {
    Json key{{"time", number(json::TIME)}, {"camera", camera_schema()}, {"sun", sun_schema()}};
    key["exposure"] = setting_schema(*find_setting("exposure"));
    // What a key leaves out is as in the key before it.
    key["exposure"].erase("default");
    key["camera"]["properties"]["fov"].erase("default");
    Json properties = base_view_properties();
    properties["ground"] = number(json::GROUND);
    properties["keys"] = {{"type", "array"},
                          {"minItems", 2},
                          {"description", "in order of time, the first at 0; what one leaves out is as before"},
                          {"items", object("a view at a time", std::move(key), {"time", "camera"})}};
    return file_text("Alpenglow flight",
                     object("timed views: SI units, angles in degrees", std::move(properties), {"keys"}));
}

} // namespace alpenglow
