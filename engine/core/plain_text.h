#pragma once

#include <string>
#include <string_view>

namespace alpenglow {

/// Text of any origin as one line for a terminal: control characters, separators of lines and marks that turn the
/// direction of writing become spaces, bytes that are not UTF-8 become "?". Cut after `longest` bytes, with "…".
std::string plain_text(std::string_view text, std::size_t longest = std::string_view::npos);

} // namespace alpenglow
