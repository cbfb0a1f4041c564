#include "support/refusal.h"

#include <fstream>

using namespace alpenglow;
using test::Refusal;

namespace {

constexpr char const* VIEW = R"({"camera": {"latitude": 46, "longitude": 7.5, "altitude": 900}, "samples": 4})";
// Far below any picture of ours, far above a JSON file. [bytes]
constexpr rlim_t FULL_DISK = 1000;
// What the driver would like to cache is not what is tried here.
std::map<std::string, std::string> const NO_DRIVER_CACHE = {{"MESA_SHADER_CACHE_DISABLE", "true"}, {"MESA_GLSL_CACHE_DISABLE", "true"}};

std::vector<Refusal> rows() {
    std::map<std::string, std::string> const view{{"view.json", VIEW}}, view_and_file{{"view.json", VIEW}, {"out", "a file"}};
    return {
        {"picture_on_a_full_disk", {"render", "view.json", "--out", "out", "--size", "64x36"}, 3, {"out/view.png", "File too large"}, view, NO_DRIVER_CACHE, FULL_DISK},
        {"radiance_on_a_full_disk", {"render", "view.json", "--out", "out", "--size", "64x36", "--format", "exr"}, 3, {"out/view.exr"}, view, NO_DRIVER_CACHE, FULL_DISK},
        {"render_into_a_file", {"render", "view.json", "--out", "out"}, 3, {"out", "choose another"}, view_and_file},
        {"render_below_a_file", {"render", "view.json", "--out", "out/pictures"}, 3, {"out/pictures", "choose another"}, view_and_file},
        {"reference_into_a_file", {"reference", "view.json", "--out", "out"}, 3, {"out", "choose another"}, view_and_file},
        {"reference_to_a_device", {"reference", "view.json", "--out", "/dev/full"}, 3, {"/dev/full", "choose another"}, view},
        {"reference_on_a_full_disk", {"reference", "view.json", "--out", "out", "--size", "16x16", "--samples", "512"}, 3, {"out/view.state", "File too large"}, view, {}, FULL_DISK},
        {"flight_into_a_file", {"fly", "--headless", "--out", "out"}, 3, {"out", "choose another"}, view_and_file},
        {"terrain_below_a_file", {"terrain", "--out", "out/t.glb"}, 3, {"out", "choose another"}, view_and_file},
        {"picture_over_a_folder", {"render", "view.json", "--out", "out", "--size", "64x36"}, 3, {"out/view.png", "directory"}, {{"view.json", VIEW}, {"out/view.png/x", ""}}},
        {"render_to_a_device", {"render", "view.json", "--out", "/dev/full"}, 3, {"/dev/full", "choose another"}, view},
        {"help_to_a_full_disk", {"--help"}, 3, {"standard output", "No space"}, {}, {}, {}, "/dev/full"},
        {"devices_to_a_full_disk", {"devices"}, 3, {"standard output", "No space"}, {}, {}, {}, "/dev/full"},
    };
}

class BadOutput : public testing::TestWithParam<Refusal> {};

/// A folder that nobody may write to while this lives.
class LockedFolder {
public:
    explicit LockedFolder(std::filesystem::path path) : path_(std::move(path)) {
        std::filesystem::create_directories(path_);
        std::filesystem::permissions(path_, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    }
    ~LockedFolder() { std::filesystem::permissions(path_, std::filesystem::perms::owner_all); }
    LockedFolder(LockedFolder const&) = delete;
    LockedFolder& operator=(LockedFolder const&) = delete;

private:
    std::filesystem::path path_;
};

} // namespace

TEST_P(BadOutput, is_refused_in_one_line_and_leaves_nothing) { test::expect_refusal(GetParam(), test::TemporaryFolder().path()); }

INSTANTIATE_TEST_SUITE_P(Outputs, BadOutput, testing::ValuesIn(rows()), test::name_of);

TEST(UnwritableFolder, is_refused_before_anything_is_drawn) {
    test::TemporaryFolder const folder;
    LockedFolder const locked(folder.path() / "out");
    for (std::vector<std::string> const& arguments : {std::vector<std::string>{"render", "view.json", "--out", "out"}, {"render", "view.json", "--out", "out/new"},
                                                      {"fly", "--headless", "--out", "out"}, {"reference", "view.json", "--out", "out"}, {"terrain", "--out", "out/t.glb"}}) {
        test::expect_refusal({arguments.front(), arguments, 3, {"out", "Permission denied"}, {{"view.json", VIEW}}}, folder.path());
    }
}

TEST(UnwritableCache, is_refused_before_the_terrain_is_made) {
    test::TemporaryFolder const folder;
    LockedFolder const locked(folder.path() / "cache");
    test::expect_refusal({"cache", {"render", "view.json", "--scene", "default", "--out", "out"}, 3, {"cache", "Permission denied", "ALPENGLOW_CACHE"},
                          {{"view.json", VIEW}}, {{"ALPENGLOW_CACHE", "cache"}}},
                         folder.path());
}

/// A picture that is already there stays whole when its successor can't be written.
TEST(FullDisk, keeps_the_picture_of_before) {
    test::TemporaryFolder const folder;
    folder.write("view.json", VIEW);
    folder.write("out/view.png", "the picture of before");
    Refusal row{"again", {"render", "view.json", "--out", "out", "--size", "64x36"}, 3, {"out/view.png"}, {}, NO_DRIVER_CACHE, FULL_DISK};
    row.leaves = {"view.json", "out/view.png"};
    test::expect_refusal(row, folder.path());
    EXPECT_EQ(read_text_file(folder.path() / "out/view.png"), "the picture of before");
}
