#include "scene/gltf_report.h"

#include "core/log.h"
#include "scene/gltf.h"

#include <algorithm>

namespace alpenglow {

namespace {

constexpr char const* SIMPLIFIED = "SIMPLIFIED";

} // namespace

std::string line_of(GltfDiagnostic const& diagnostic) {
    std::string const where = diagnostic.pointer.empty() ? "" : diagnostic.pointer + ": ";
    std::string const code = diagnostic.code == SIMPLIFIED ? "" : " [" + diagnostic.code + "]";
    return where + diagnostic.message + code;
}

std::vector<std::string> warning_lines(GltfSummary const& summary) {
    std::vector<std::string> lines;
    std::map<std::string, std::size_t> counts;
    for (GltfDiagnostic const& warning : summary.warnings)
        if (warning.code == SIMPLIFIED || ++counts[warning.code] == 1) lines.push_back(line_of(warning));
    for (auto const& [code, count] : counts)
        if (count > 1) lines.push_back(std::to_string(count - 1) + " more [" + code + "]");
    return lines;
}

} // namespace alpenglow

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
    keep(diagnostic, ++counts_[diagnostic.code] == 1);
}

void Report::warn(std::string const& line) {
    if (warned_.insert(line).second) keep({"", SIMPLIFIED, line}, true);
}

void Report::log_counts() const {
    for (auto const& [code, count] : counts_) {
        if (count < 2) continue;
        log_warning(printable(file_.string()) + ": " + std::to_string(count - 1) + " more [" + code + "]");
    }
}

void Report::keep(GltfDiagnostic const& diagnostic, bool log) {
    constexpr std::size_t most = 1000;
    if (warnings_.size() < most) warnings_.push_back(diagnostic);
    if (log) log_warning(printable(file_.string()) + ": " + line_of(diagnostic));
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
