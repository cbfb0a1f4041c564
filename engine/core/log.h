#pragma once

#include <string_view>

namespace alpenglow {

/// One line on stderr. A warning says what was left out or changed; information is for a person who waits.
void log_info(std::string_view line);
void log_warning(std::string_view line);
/// Silences log_info (warnings stay), for `--quiet` and tests.
void set_quiet(bool quiet);

} // namespace alpenglow
