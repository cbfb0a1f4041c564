#include "scene/gltf_report.h"

#include "core/error.h"
#include "core/log.h"

#include <algorithm>

namespace alpenglow::gltf {

void Report::fail(std::string const& pointer, std::string const& reason, std::string const& advice) const {
    throw Error(ErrorKind::bad_input, pointer.empty() ? reason : pointer + ": " + reason, file_.string(), advice);
}

void Report::warn(std::string const& line) {
    if (warned_.insert(line).second) log_warning(printable(file_.string()) + ": " + line);
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 160;
    std::string line(text.substr(0, longest));
    if (text.size() > longest) line += "…";
    std::replace_if(line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

} // namespace alpenglow::gltf
