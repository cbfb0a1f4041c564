#include "scene/gltf_report.h"

#include "core/log.h"

#include <algorithm>

namespace alpenglow::gltf {

void Report::fail(std::string const& pointer, std::string const& reason, std::string const& advice) const {
    refuse("NOT_LOADABLE", pointer, reason, advice);
}

void Report::refuse(Code code, std::string const& pointer, std::string const& reason, std::string const& advice) const {
    throw GltfError({pointer, std::string(code.name()), reason}, file_.string(), advice);
}

void Report::refuse_beyond(std::string_view name, int limit, std::string const& pointer,
                           std::string const& reason) const {
    std::string const setting(name);
    refuse("LIMIT_EXCEEDED", pointer, reason + ", more than the limit of " + std::to_string(limit),
           "where the file is to be trusted, raise it with --set " + setting + "=NUMBER");
}

void Report::say(Code code, std::string const& pointer, std::string const& reason) {
    if (code.refuses()) refuse(code, pointer, reason);
    warn(code, pointer, reason);
}

void Report::warn(Code code, std::string const& pointer, std::string const& reason) {
    warn({pointer, std::string(code.name()), reason});
}

void Report::warn(GltfDiagnostic const& diagnostic) {
    keep(diagnostic);
    if (++counts_[diagnostic.code] > 1) return;
    log_warning(printable(file_.string()) + ": " + (diagnostic.pointer.empty() ? "" : diagnostic.pointer + ": ") +
                diagnostic.message + " [" + diagnostic.code + "]");
}

void Report::warn(std::string const& line) {
    if (!warned_.insert(line).second) return;
    keep({"", "SIMPLIFIED", line});
    log_warning(printable(file_.string()) + ": " + line);
}

void Report::log_counts() const {
    for (auto const& [code, count] : counts_) {
        if (count < 2) continue;
        log_warning(printable(file_.string()) + ": " + std::to_string(count - 1) + " more [" + code + "]");
    }
}

void Report::keep(GltfDiagnostic diagnostic) {
    constexpr std::size_t most = 1000;
    if (warnings_ && warnings_->size() < most) warnings_->push_back(std::move(diagnostic));
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 160;
    std::string line(text.substr(0, longest));
    if (text.size() > longest) line += "…";
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

} // namespace alpenglow::gltf
