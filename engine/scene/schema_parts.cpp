#include "scene/schema_parts.h"

namespace alpenglow::schema {

Json text(std::string const& description) { return {{"type", "string"}, {"description", description}}; }

Json number(json::NumberKey const& key) {
    Json schema{{"type", "number"}, {"description", key.help}};
    schema[key.above_smallest ? "exclusiveMinimum" : "minimum"] = key.smallest;
    schema["maximum"] = key.largest;
    if (key.fallback) schema["default"] = *key.fallback;
    return schema;
}

Json triple(json::NumberKey const& key, std::string const& description) {
    json::NumberKey channel = key;
    channel.help = "of red, green, blue";
    return {
        {"type", "array"}, {"description", description}, {"items", number(channel)}, {"minItems", 3}, {"maxItems", 3}};
}

Json object(std::string const& description, Json properties, std::vector<std::string> const& required) {
    Json schema{{"type", "object"}, {"description", description}, {"additionalProperties", false}};
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = required;
    return schema;
}

Json numbers(std::span<json::NumberKey const> keys) {
    Json properties = Json::object();
    for (json::NumberKey const& key : keys) properties[std::string(key.name)] = number(key);
    return properties;
}

std::vector<std::string> required_names(std::span<json::NumberKey const> keys) {
    std::vector<std::string> names;
    for (json::NumberKey const& key : keys) {
        if (!key.fallback) names.emplace_back(key.name);
    }
    return names;
}

} // namespace alpenglow::schema
