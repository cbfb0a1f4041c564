#pragma once

#include <string>

namespace alpenglow {

/// docs/settings.md: every setting of the table, in Markdown.
std::string settings_document();

} // namespace alpenglow
