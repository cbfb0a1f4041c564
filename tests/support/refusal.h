#pragma once

#include "support/files.h"
#include "support/process.h"

#include <algorithm>
#include <ostream>
#include <set>
#include <sstream>

namespace alpenglow::test {

/// One row of a table of things that the program must refuse. It runs in a new folder, so that file names are short.
struct Refusal {
    std::string name;                            ///< of the test
    std::vector<std::string> arguments;
    int exit_code;
    std::vector<std::string> says;               ///< what the line on stderr has to hold
    std::map<std::string, std::string> files{};  ///< text by name, written before
    std::map<std::string, std::string> environment{};
    std::optional<rlim_t> largest_file{};        ///< [bytes]
    std::optional<std::filesystem::path> output{}; ///< where stdout goes
    std::set<std::string> leaves{};              ///< finished files that may stay behind
};

inline std::ostream& operator<<(std::ostream& out, Refusal const& refusal) { return out << refusal.name; }
inline std::string name_of(::testing::TestParamInfo<Refusal> const& info) { return info.param.name; }

inline std::set<std::string> files_below(std::filesystem::path const& folder) {
    std::set<std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(folder).generic_string());
    }
    return files;
}

inline std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The last line, and no other, is the error; it says what, where and, in brackets, what to do.
inline void expect_error_line(ProcessResult const& result, std::vector<std::string> const& says) {
    std::vector<std::string> const lines = lines_of(result.errors);
    auto const is_error = [](std::string const& line) { return line.starts_with("alpenglow: "); };
    ASSERT_EQ(std::ranges::count_if(lines, is_error), 1) << result.errors;
    ASSERT_TRUE(is_error(lines.back())) << result.errors;
    EXPECT_TRUE(lines.back().ends_with(")")) << "no advice: " << lines.back();
    EXPECT_LT(lines.back().size(), 1200u) << lines.back();
    for (std::string const& part : says) EXPECT_NE(lines.back().find(part), std::string::npos) << part << " is not in: " << lines.back();
}

/// Runs the row: the exit code, the error's line, no crash, and nothing left behind but what may stay.
inline void expect_refusal(Refusal const& refusal, std::filesystem::path const& folder) {
    std::set<std::string> allowed = refusal.leaves;
    for (auto const& [name, text] : refusal.files) {
        write_text_file(folder / name, text);
        allowed.insert(name);
    }
    ProcessResult const result = run({.program = ALPENGLOW_PROGRAM,
                                      .arguments = refusal.arguments,
                                      .environment = refusal.environment,
                                      .folder = folder,
                                      .largest_file = refusal.largest_file,
                                      .output = refusal.output});
    EXPECT_EQ(result.signal, 0) << result.errors;
    EXPECT_EQ(result.exit_code, refusal.exit_code) << result.errors;
    EXPECT_EQ(result.output, "");
    expect_error_line(result, refusal.says);
    for (std::string const& file : files_below(folder)) EXPECT_TRUE(allowed.contains(file)) << file << " was left behind";
}

} // namespace alpenglow::test
