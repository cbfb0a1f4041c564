#include "core/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

struct Include {
    std::string file; ///< from the root, with '/'
    int line = 0;
    std::string target;

    std::string place() const { return file + ":" + std::to_string(line) + ": includes " + target; }
};

/// For each folder that is checked, the first folders of the quoted includes that its files may have.
std::map<std::string, Names> const ALLOWED = {
    {"engine/core", {"core"}},
    {"engine/image", {"image", "core"}},
    {"engine/gpu", {"gpu", "core"}},
    {"engine/scene", {"scene", "image", "core"}},
    {"engine/terrain", {"terrain", "scene", "image", "core"}},
    {"engine/render", {"render", "gpu", "scene", "image", "core", "interop", "atmosphere", "surface", "encoding"}},
    {"engine/reference", {"reference", "scene", "core", "surface"}},
    {"shaders/interop", {"interop"}},
    {"shaders/atmosphere", {"interop", "atmosphere"}},
    {"shaders/surface", {"interop", "surface", "encoding", "atmosphere"}},
    {"shaders/encoding", {"interop", "encoding"}},
    {"shaders/frame", {"interop", "atmosphere", "surface", "encoding", "frame"}},
    {"shaders/models", {"interop", "atmosphere", "surface", "encoding", "frame", "models"}},
    {"shaders/passes", {"interop", "atmosphere", "surface", "encoding", "frame", "models"}},
    {"sandbox", {"sandbox", "render", "reference", "terrain", "scene", "gpu", "image", "core", "interop"}},
};

/// These layers are linked privately: a header that includes them would hand them on.
std::map<std::string, Names> const ONLY_IN_SOURCES = {{"engine/scene", {"image"}}};

Names const WITHOUT_VULKAN = {"engine/core", "engine/image", "engine/scene", "engine/terrain", "engine/reference"};

/// Libraries that one source file of ours may include, and the folder where that file is.
std::map<std::string, std::string> const ONE_FILE_ONLY = {{"GLFW/glfw3.h", "sandbox"},
                                                             {"tiny_gltf.h", "engine/scene"},
                                                             {"embree3/rtcore.h", "engine/reference"}};

Names const TOP_LEVEL = {"README.md", "LICENSE", "CMakeLists.txt", "CMakePresets.json", "run", "test", "engine", "shaders",
                         "assets", "sandbox", "tests", "docs", "out"};

std::string folder_of(std::string const& file) {
    for (auto const& [folder, allowed] : ALLOWED) {
        if (file.starts_with(folder + "/")) return folder;
    }
    return {};
}

bool is_vulkan(std::string const& target) {
    return std::regex_search(target, std::regex("^<(vulkan/|volk\\.h|vk_|backends/imgui_impl_vulkan|imgui_impl_vulkan)"));
}

std::string quoted_violation(Include const& include, std::string const& folder, std::string const& path) {
    std::string const first = path.substr(0, path.find('/'));
    bool const in_header = fs::path(include.file).extension() == ".h";
    if (path.find('/') == std::string::npos) return "give the path from engine/ or shaders/, or <> for a library";
    if (path.find("..") != std::string::npos) return "paths do not climb";
    if (!ALLOWED.at(folder).contains(first)) return folder + " may not know " + first;
    if (auto const only = ONLY_IN_SOURCES.find(folder); in_header && only != ONLY_IN_SOURCES.end() && only->second.contains(first)) {
        return folder + " uses " + first + " in its sources only";
    }
    fs::path const file = include.file;
    bool const pass_to_pass = file.parent_path() == "engine/render/passes" && path.starts_with("render/passes/");
    if (pass_to_pass && fs::path(path).stem() != file.stem()) return "passes never include each other";
    bool const model_to_model = file.parent_path() == "engine/render/models" && path.starts_with("render/models/");
    if (model_to_model && fs::path(path).stem() != "model" && fs::path(path).stem() != file.stem())
        return "models never include each other";
    return {};
}

/// Why this include may not be; empty where it may.
std::string violation(Include const& include) {
    std::string const folder = folder_of(include.file);
    if (folder.empty()) return "this folder has no rule: add it to the test and to the architecture's document";
    if (include.target.starts_with('"')) return quoted_violation(include, folder, include.target.substr(1, include.target.size() - 2));
    if (WITHOUT_VULKAN.contains(folder) && is_vulkan(include.target)) return folder + " never includes Vulkan";
    return {};
}

std::vector<Include> includes_of(std::string const& file, std::string const& text) {
    static std::regex const pattern(R"(^\s*#\s*include\s*(<[^>]*>|"[^"]*"))");
    std::vector<Include> includes;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (std::smatch match; std::regex_search(line, match, pattern)) includes.push_back({file, number, match[1]});
    }
    return includes;
}

std::vector<Include> includes_under(fs::path const& root) {
    std::vector<Include> all;
    for (char const* const folder : {"engine", "shaders", "sandbox"}) {
        if (!fs::is_directory(root / folder)) continue;
        for (fs::directory_entry const& entry : fs::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file() || entry.path().extension() == ".txt") continue;
            auto const found = includes_of(fs::relative(entry.path(), root).generic_string(), alpenglow::read_text_file(entry.path()));
            all.insert(all.end(), found.begin(), found.end());
        }
    }
    return all;
}

std::vector<std::string> one_file_violations(std::vector<Include> const& includes) {
    std::vector<std::string> found;
    for (auto const& [header, folder] : ONE_FILE_ONLY) {
        std::string home;
        for (Include const& include : includes) {
            if (include.target.substr(1, include.target.size() - 2) != header) continue;
            bool const right_place = fs::path(include.file).parent_path() == folder && include.file.ends_with(".cpp");
            if (!right_place) found.push_back(include.place() + ": only one source file in " + folder + " includes it");
            if (!home.empty() && home != include.file) found.push_back(include.place() + ": so does " + home);
            home = include.file;
        }
    }
    return found;
}

std::vector<std::string> violations_under(fs::path const& root) {
    std::vector<Include> const includes = includes_under(root);
    std::vector<std::string> found = one_file_violations(includes);
    for (Include const& include : includes) {
        if (std::string const reason = violation(include); !reason.empty()) found.push_back(include.place() + ": " + reason);
    }
    for (fs::directory_entry const& entry : fs::directory_iterator(root)) {
        std::string const name = entry.path().filename().string();
        if (!name.starts_with('.') && !TOP_LEVEL.contains(name)) found.push_back(name + ": is not one of the top level's entries");
    }
    return found;
}

/// A tree with one file in it, removed at the end.
class PlantedTree {
public:
    PlantedTree(std::string const& file, std::string const& text) : root_(fs::path(testing::TempDir()) / ("layers" + std::to_string(::getpid()))) {
        fs::remove_all(root_);
        add(file, text);
    }
    ~PlantedTree() { fs::remove_all(root_); }
    void add(std::string const& file, std::string const& text) { alpenglow::write_text_file(root_ / file, text); }
    fs::path const& root() const { return root_; }

private:
    fs::path root_;
};

std::string reason_for(std::string const& file, std::string const& target) { return violation({file, 1, target}); }

} // namespace

TEST(Layering, no_include_breaks_the_architecture) {
    ASSERT_FALSE(includes_under(ALPENGLOW_SOURCE).empty());
    for (std::string const& text : violations_under(ALPENGLOW_SOURCE)) ADD_FAILURE() << text;
}

TEST(Layering, a_planted_violation_is_found_with_its_file_and_line) {
    PlantedTree const tree("engine/scene/planted.cpp", "#include \"scene/scene.h\"\n\n  #  include <vulkan/vulkan.hpp>\n");
    auto const found = violations_under(tree.root());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "engine/scene/planted.cpp:3: includes <vulkan/vulkan.hpp>: engine/scene never includes Vulkan");
}

TEST(Layering, a_library_of_one_file_is_found_in_a_second) {
    PlantedTree tree("engine/scene/gltf_parser.cpp", "#include <tiny_gltf.h>\n");
    EXPECT_TRUE(violations_under(tree.root()).empty());
    tree.add("engine/scene/other.cpp", "#include <tiny_gltf.h>\n");
    EXPECT_EQ(violations_under(tree.root()).size(), 1u);
    tree.add("engine/render/window.cpp", "#include <GLFW/glfw3.h>\n");
    EXPECT_EQ(violations_under(tree.root()).size(), 2u);
}

TEST(Layering, an_unknown_entry_of_the_top_level_is_found) {
    PlantedTree tree("engine/core/a.h", "");
    EXPECT_TRUE(violations_under(tree.root()).empty());
    tree.add("notes.txt", "");
    EXPECT_EQ(violations_under(tree.root()).size(), 1u);
}

TEST(Layering, each_rule_forbids_and_allows) {
    EXPECT_NE(reason_for("engine/core/a.cpp", "\"image/image.h\""), "");
    EXPECT_NE(reason_for("engine/image/a.cpp", "\"scene/scene.h\""), "");
    EXPECT_NE(reason_for("engine/gpu/a.cpp", "\"scene/scene.h\""), "");
    EXPECT_NE(reason_for("engine/scene/a.cpp", "\"gpu/device.h\""), "");
    EXPECT_NE(reason_for("engine/scene/a.h", "\"image/image.h\""), "");
    EXPECT_EQ(reason_for("engine/scene/a.cpp", "\"image/image.h\""), "");
    EXPECT_NE(reason_for("engine/terrain/a.cpp", "\"render/frame.h\""), "");
    EXPECT_NE(reason_for("engine/reference/a.cpp", "\"atmosphere/phase.h\""), "");
    EXPECT_EQ(reason_for("engine/reference/a.cpp", "\"surface/brdf.h\""), "");
    EXPECT_NE(reason_for("engine/reference/a.cpp", "<vulkan/vulkan.h>"), "");
    EXPECT_NE(reason_for("engine/render/a.cpp", "\"terrain/terrain.h\""), "");
    EXPECT_EQ(reason_for("engine/render/a.cpp", "<vulkan/vulkan.hpp>"), "");
    EXPECT_NE(reason_for("engine/render/passes/a.cpp", "\"render/passes/b.h\""), "");
    EXPECT_EQ(reason_for("engine/render/passes/a.cpp", "\"render/passes/a.h\""), "");
    EXPECT_EQ(reason_for("engine/render/frame.cpp", "\"render/passes/a.h\""), "");
    EXPECT_NE(reason_for("engine/render/a.cpp", "\"../gpu/device.h\""), "");
    EXPECT_NE(reason_for("engine/render/a.cpp", "\"frame.h\""), "");
    EXPECT_NE(reason_for("engine/newcomer/a.cpp", "\"core/error.h\""), "");
    EXPECT_NE(reason_for("shaders/atmosphere/a.h", "\"passes/b.comp\""), "");
    EXPECT_NE(reason_for("shaders/passes/a.comp", "\"gpu/device.h\""), "");
    EXPECT_EQ(reason_for("shaders/passes/a.comp", "\"atmosphere/phase.h\""), "");
}
