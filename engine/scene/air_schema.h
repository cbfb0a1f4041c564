#pragma once

#include <nlohmann/json.hpp>

namespace alpenglow::schema {

/// Of the "air" of a planet file.
nlohmann::ordered_json air();

} // namespace alpenglow::schema
