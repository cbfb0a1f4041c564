#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alpenglow::gltf {

/// What a data URI holds; nothing where `uri` has another scheme or none. `valid` is false for broken base64.
struct DataUri {
    bool valid = false;
    std::vector<std::byte> bytes;
};
std::optional<DataUri> parse_data_uri(std::string_view uri);

/// The media type that a data URI gives, "" where it gives none or is no data URI.
std::string_view data_uri_type(std::string_view uri);

/// The file that a relative URI names, percent-decoded once. `reason` is set, and the path empty, where it is not a
/// plain path inside `folder`: absolute, with a scheme, "..", a backslash, a NUL, or through a link that leaves the
/// folder.
struct FileUri {
    std::filesystem::path path;
    std::string reason;
    bool malformed = false; ///< it is no URI at all
};
FileUri resolve_file_uri(std::string_view uri, std::filesystem::path const& folder);

} // namespace alpenglow::gltf
