#pragma once

#include "scene/json_reader.h"

#include <span>
#include <string>
#include <vector>

/// Of what the JSON schemas of our files are put together.
namespace alpenglow::schema {

using Json = nlohmann::ordered_json;

Json text(std::string const& description);
Json number(json::NumberKey const& key);
/// Red, green and blue.
Json triple(json::NumberKey const& key, std::string const& description);
/// Refuses other keys than those of `properties`.
Json object(std::string const& description, Json properties, std::vector<std::string> const& required);
/// Properties of these names.
Json numbers(std::span<json::NumberKey const> keys);
/// Of the keys without a fallback.
std::vector<std::string> required_names(std::span<json::NumberKey const> keys);

} // namespace alpenglow::schema
