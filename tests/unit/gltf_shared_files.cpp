#include "core/error.h"
#include "core/log.h"
#include "scene/gltf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

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

std::map<std::string, std::string> const refused = {
    {"Compatibility_04.gltf", "/asset/minVersion: needs a reader of glTF 2.1"},
    {"Compatibility_05.gltf", "FAKE_materials_quantumRendering is required and not supported"},
    {"BoxDraco.gltf", "is compressed by KHR_draco_mesh_compression, which is not supported"},
    {"BoxMeshopt.glb", "EXT_meshopt_compression is required and not supported"},
    {"BoxMeshopt.gltf", "EXT_meshopt_compression is required and not supported"},
    {"DracoSparseMesh.gltf", "KHR_draco_mesh_compression is required and not supported"},
    {"DenseSphere.glb", "KHR_draco_mesh_compression is required and not supported"},
};

} // namespace

TEST_F(GltfSharedFiles, valid_ones_load_or_are_refused_for_a_named_reason) {
    std::size_t loaded = 0;
    for (fs::path const& file : scenes_in(shared_folder() / "valid")) {
        auto const reason = refused.find(file.filename().string());
        try {
            load_gltf(file);
            ++loaded;
            EXPECT_TRUE(reason == refused.end()) << file << " should be refused: " << reason->second;
        } catch (Error const& error) {
            ASSERT_TRUE(reason != refused.end()) << error.what();
            EXPECT_NE(std::string(error.what()).find(reason->second), std::string::npos) << error.what();
        }
    }
    EXPECT_GE(loaded, 140u);
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
