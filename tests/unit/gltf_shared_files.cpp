#include "core/error.h"
#include "core/log.h"
#include "scene/gltf.h"
#include "support/documents.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

using namespace alpenglow;
namespace fs = std::filesystem;

namespace {

/// The collection of public glTF files that stands beside the source; it is not part of it.
fs::path shared_folder() {
    if (char const* const given = std::getenv("ALPENGLOW_SHARED")) return fs::path(given) / "gltf";
    return fs::path(ALPENGLOW_SOURCE) / "../shared/gltf";
}

std::vector<fs::path> scenes_in(fs::path const& folder) {
    std::vector<fs::path> files;
    for (fs::directory_entry const& entry : fs::recursive_directory_iterator(folder)) {
        fs::path const extension = entry.path().extension();
        if (extension == ".gltf" || extension == ".glb") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

class GltfSharedFiles : public testing::Test {
protected:
    void SetUp() override {
        if (fs::is_directory(shared_folder())) return;
        if (std::getenv("CI")) FAIL() << shared_folder() << " is missing; in CI it must be there";
        GTEST_SKIP() << shared_folder() << " is not here; set ALPENGLOW_SHARED to the folder that holds gltf/";
    }
};

/// Why a file is refused, without its path.
std::string reason_of(Error const& error, fs::path const& file) {
    std::string line = test::without_usual_advice(error.what());
    std::string const start = file.string() + ": ";
    return line.starts_with(start) ? line.substr(start.size()) : line;
}

std::string table_row(fs::path const& file, fs::path const& folder) {
    std::string const name = "| " + fs::relative(file, folder).string() + " | ";
    try {
        GltfSummary summary;
        Scene const scene = load_gltf(file, {}, &summary);
        std::string warnings;
        for (std::string const& line : warning_lines(summary)) warnings += (warnings.empty() ? "" : "; ") + line;
        return name + std::to_string(triangle_count(scene)) + " | " + warnings + " | |\n";
    } catch (Error const& error) {
        return name + "| | " + reason_of(error, file) + " |\n";
    }
}

} // namespace

TEST_F(GltfSharedFiles, valid_ones_load_or_are_refused_as_the_document_says) {
    fs::path const folder = shared_folder() / "valid";
    std::string table = "| file | triangles | warnings | refused |\n|---|---|---|---|\n";
    for (fs::path const& file : scenes_in(folder)) table += table_row(file, folder);
    test::expect_section("gltf.md", "valid files", table);
}

TEST_F(GltfSharedFiles, invalid_ones_load_or_throw_an_error_and_nothing_else) {
    std::size_t tried = 0;
    for (fs::path const& file : scenes_in(shared_folder() / "invalid")) {
        ++tried;
        try {
            load_gltf(file);
        } catch (Error const& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
            EXPECT_TRUE(std::string_view(error.what()).starts_with(file.string())) << error.what();
        } catch (std::exception const& other) {
            ADD_FAILURE() << file << ": " << other.what();
        }
    }
    EXPECT_GE(tried, 300u);
}
