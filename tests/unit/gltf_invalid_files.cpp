#include "core/files.h"
#include "scene/gltf.h"
#include "scene/gltf_codes.h"
#include "support/documents.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

using namespace alpenglow;
namespace fs = std::filesystem;

namespace {

/// The collection of public glTF files that stands beside the source; it is not part of it.
fs::path shared_folder() {
    char const* const given = std::getenv("ALPENGLOW_SHARED");
    return (given ? fs::path(given) : fs::path(ALPENGLOW_SOURCE) / "../shared") / "gltf";
}

class GltfInvalidFiles : public testing::Test {
protected:
    void SetUp() override {
        if (fs::is_directory(shared_folder())) return;
        if (std::getenv("CI")) FAIL() << shared_folder() << " is missing; in CI it must be there";
        GTEST_SKIP() << shared_folder() << " is not here; set ALPENGLOW_SHARED to the folder that holds gltf/";
    }
};

using Codes = std::set<std::string>;

struct Outcome {
    std::string file;
    bool has_report = false;
    Codes reported{}; ///< errors of the validator's report
    bool refused = false;
    Codes said{}; ///< warned of, and refused for
    std::string reason{};

    bool agrees() const {
        return std::ranges::any_of(said, [&](std::string const& code) { return reported.contains(code); });
    }
};

/// The report that stands beside a file of the official validator's tests.
void read_report(fs::path file, Outcome& outcome) {
    file += ".report.json";
    outcome.has_report = fs::exists(file);
    if (!outcome.has_report) return;
    nlohmann::json const report = nlohmann::json::parse(read_text_file(file));
    for (nlohmann::json const& message : report["issues"]["messages"]) {
        if (message["severity"] == 0) outcome.reported.insert(message["code"]);
    }
}

Outcome try_file(fs::path const& file, fs::path const& folder) {
    Outcome outcome{.file = file.lexically_relative(folder).generic_string()};
    read_report(file, outcome);
    GltfSummary summary;
    try {
        load_gltf(file, {}, &summary);
    } catch (GltfError const& error) {
        outcome.refused = true;
        outcome.said.insert(error.diagnostic().code);
        outcome.reason = error.diagnostic().pointer + " " + error.diagnostic().message;
    }
    for (GltfDiagnostic const& warning : summary.warnings) outcome.said.insert(warning.code);
    return outcome;
}

std::vector<Outcome> try_folder(fs::path const& folder) {
    std::vector<Outcome> outcomes;
    for (fs::directory_entry const& entry : fs::recursive_directory_iterator(folder)) {
        fs::path const extension = entry.path().extension();
        if (extension == ".gltf" || extension == ".glb") outcomes.push_back(try_file(entry.path(), folder));
    }
    std::ranges::sort(outcomes, {}, &Outcome::file);
    return outcomes;
}

std::string table_of(std::vector<Outcome> const& outcomes) {
    std::string text = "| file | the validator's errors | we | say |\n|---|---|---|---|\n";
    std::size_t errors = 0, agreeing = 0;
    for (Outcome const& outcome : outcomes) {
        errors += !outcome.reported.empty();
        agreeing += outcome.agrees();
        text += fmt::format("| {} | {} | {} | {} |\n", outcome.file,
                            outcome.has_report ? fmt::format("{}", fmt::join(outcome.reported, ", ")) : "(no report)",
                            outcome.refused ? "refuse" : outcome.said.empty() ? "load" : "load, warn",
                            fmt::join(outcome.said, ", "));
    }
    text += fmt::format("\nOf {} files whose report has an error, {} yield a diagnostic with a code that the report lists.\n",
                        errors, agreeing);
    return text;
}

} // namespace

TEST_F(GltfInvalidFiles, are_diagnosed_as_the_stored_table_says) {
    std::vector<Outcome> const outcomes = try_folder(shared_folder() / "invalid");
    std::size_t errors = 0, agreeing = 0;
    for (Outcome const& outcome : outcomes) {
        if (outcome.reported.empty()) continue;
        ++errors;
        agreeing += outcome.agrees();
        EXPECT_FALSE(outcome.said.empty()) << outcome.file << " has errors, and nothing was said";
    }
    EXPECT_GE(errors, 243u);
    EXPECT_GE(agreeing * 10, errors * 9);
    test::expect_section("gltf.md", "invalid files", table_of(outcomes));
}

/// A false alarm would be a code of the validator's errors that its report of the file doesn't list.
TEST_F(GltfInvalidFiles, controls_are_not_accused) {
    Codes ours;
    for (char const* const code : {"SIMPLIFIED", "NOT_LOADABLE", "LIMIT_EXCEEDED", "URI_NOT_ALLOWED",
                                   "UNSUPPORTED_EXTENSION", "UNSUPPORTED_VERSION"})
        ours.insert(code);
    // Warnings, not errors, of the validator's.
    for (char const* const code : {"GLB_EXTRA_DATA", "IMAGE_UNRECOGNIZED_FORMAT", "VALUE_NOT_IN_LIST"}) ours.insert(code);
    std::size_t controls = 0;
    for (Outcome const& outcome : try_folder(shared_folder() / "invalid/khronos-validator")) {
        if (!outcome.has_report || !outcome.reported.empty()) continue;
        ++controls;
        for (std::string const& code : outcome.said)
            EXPECT_TRUE(ours.contains(code)) << outcome.file << " is accused of " << code << ": " << outcome.reason;
    }
    EXPECT_GE(controls, 100u);
}
