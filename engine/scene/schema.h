#pragma once

#include <string>

namespace alpenglow {

/// JSON Schemas (draft 2020-12) of our files, made from the keys and settings that the readers use. The files of these
/// names in assets/ hold the same text.
std::string planet_schema_text();
std::string view_schema_text();
std::string flight_schema_text();

} // namespace alpenglow
