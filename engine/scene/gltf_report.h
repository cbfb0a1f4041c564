#pragma once

#include "scene/gltf_codes.h"
#include "scene/gltf_diagnostic.h"
#include "scene/gltf_limits.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace alpenglow::gltf {

/// What to do about most errors: few people mend glTF by hand.
inline constexpr char const* EXPORT_AGAIN = "export the scene again, or choose another";

/// Where errors and warnings of one file go. `pointer` is the JSON pointer of the value that is wrong
/// ("/accessors/3/count"), or empty where the fault is in the file as a whole.
class Report {
public:
    /// The first 1000 warnings go to `warnings` as well as to the log.
    Report(std::filesystem::path file, GltfLimits const& limits, std::vector<GltfDiagnostic>& warnings)
        : file_(std::move(file)), limits_(limits), warnings_(warnings) {}

    std::filesystem::path const& file() const { return file_; }
    GltfLimits const& limits() const { return limits_; }
    /// Throws GltfError with the code NOT_LOADABLE.
    [[noreturn]] void fail(std::string const& pointer, std::string const& reason,
                           std::string const& advice = EXPORT_AGAIN) const;
    /// Throws GltfError.
    [[noreturn]] void refuse(Code code, std::string const& pointer, std::string const& reason,
                             std::string const& advice = EXPORT_AGAIN) const;
    /// Refuses what is beyond the limit of the setting `name`. `reason` says what is.
    [[noreturn]] void refuse_beyond(std::string_view name, int limit, std::string const& pointer,
                                    std::string const& reason) const;
    /// Refuses the file or warns, as the code's row in the table says.
    void say(Code code, std::string const& pointer, std::string const& reason);
    /// The first warning of each code is logged, the others are counted.
    void warn(Code code, std::string const& pointer, std::string const& reason);
    void warn(GltfDiagnostic const& diagnostic);
    /// Each different line is logged once.
    void warn(std::string const& line);
    /// Logs how many more warnings of each code there were.
    void log_counts() const;

private:
    void keep(GltfDiagnostic const& diagnostic, bool log);

    std::filesystem::path file_;
    GltfLimits limits_;
    std::set<std::string> warned_;
    std::map<std::string, std::size_t> counts_;
    std::vector<GltfDiagnostic>& warnings_;
};

/// Text from a file, fit for a line: control characters replaced, cut after 160 bytes.
std::string printable(std::string_view text);

} // namespace alpenglow::gltf
