#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace alpenglow::test {

using Json = nlohmann::json;

inline bool has_type(Json const& value, std::string const& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer() || (value.is_number() && value.get<double>() == static_cast<double>(value.get<int>()));
    return type == "number" && value.is_number();
}

/// What a JSON Schema has against a value, empty for nothing. The keywords that our schemas use, and no others.
inline std::string schema_objection(Json const& schema, Json const& value, std::string const& at = "") {
    for (auto const& [keyword, rule] : schema.items()) {
        if (keyword == "$schema" || keyword == "title" || keyword == "description" || keyword == "default" || keyword == "required" ||
            keyword == "additionalProperties" || keyword == "dependentRequired") continue;
        if (keyword == "type") {
            if (!has_type(value, rule)) return at + ": not of type " + rule.dump();
        } else if (keyword == "enum") {
            if (std::find(rule.begin(), rule.end(), value) == rule.end()) return at + ": not in " + rule.dump();
        } else if (keyword == "minimum") {
            if (value.is_number() && value < rule) return at + ": too small";
        } else if (keyword == "exclusiveMinimum") {
            if (value.is_number() && value <= rule) return at + ": too small";
        } else if (keyword == "maximum") {
            if (value.is_number() && value > rule) return at + ": too large";
        } else if (keyword == "minItems") {
            if (value.size() < rule) return at + ": too few items";
        } else if (keyword == "maxItems") {
            if (value.size() > rule) return at + ": too many items";
        } else if (keyword == "items") {
            for (Json const& item : value) {
                if (std::string found = schema_objection(rule, item, at + "/[]"); !found.empty()) return found;
            }
        } else if (keyword == "oneOf") {
            int fitting = 0;
            for (Json const& choice : rule) fitting += schema_objection(choice, value, at).empty();
            if (fitting != 1) return at + ": fits " + std::to_string(fitting) + " of the choices";
        } else if (keyword == "properties") {
            if (!value.is_object()) return at + ": not an object";
            for (auto const& [key, member] : value.items()) {
                if (!rule.contains(key)) return at + ": unknown key " + key;
                if (std::string found = schema_objection(rule[key], member, at + "/" + key); !found.empty()) return found;
            }
        } else {
            return at + ": the validator does not know the keyword " + keyword;
        }
    }
    for (Json const& name : schema.value("required", Json::array())) {
        if (!value.contains(name.get<std::string>())) return at + ": has no " + name.dump();
    }
    Json const dependent = schema.value("dependentRequired", Json::object());
    for (auto const& [key, needed] : dependent.items()) {
        for (Json const& name : needed) {
            if (value.contains(key) && !value.contains(name.get<std::string>())) return at + ": " + key + " needs " + name.dump();
        }
    }
    return {};
}

} // namespace alpenglow::test
