#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace alpenglow::gltf {

/// What to do about most errors: few people mend glTF by hand.
inline constexpr char const* EXPORT_AGAIN = "export the scene again, or choose another";

/// Where errors and warnings of one file go. `pointer` is the JSON pointer of the value that is wrong
/// ("/accessors/3/count"), or empty where the fault is in the file as a whole.
class Report {
public:
    explicit Report(std::filesystem::path file) : file_(std::move(file)) {}

    std::filesystem::path const& file() const { return file_; }
    /// Throws Error(bad_input).
    [[noreturn]] void fail(std::string const& pointer, std::string const& reason,
                           std::string const& advice = EXPORT_AGAIN) const;
    /// Each different line is logged once.
    void warn(std::string const& line);
    /// What was warned of.
    std::set<std::string> const& warnings() const { return warned_; }

private:
    std::filesystem::path file_;
    std::set<std::string> warned_;
};

/// Text from a file, fit for a line: control characters replaced, cut after 160 bytes.
std::string printable(std::string_view text);

} // namespace alpenglow::gltf
