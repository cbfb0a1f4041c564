#include "support/cost.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

// A scene names files beside it and nothing else, and never waits for one.

namespace {

constexpr char const* only_beside = "; only files beside the scene are read";

/// A scene's folder with everything in it that a URI could be led astray by, and a file that lies outside of it.
class Folder {
public:
    Folder() {
        std::vector<std::byte> const bytes(36);
        write_file(inner() / "inside.bin", bytes);
        write_file(inner() / "a/inside.bin", bytes);
        write_file(root_.path() / "outside.bin", bytes);
        fs::create_symlink("../outside.bin", inner() / "link.bin");
        fs::create_directory_symlink("..", inner() / "links");
        fs::create_symlink("/dev/zero", inner() / "endless.bin");
        fs::create_symlink("loop.bin", inner() / "loop.bin");
        fs::create_symlink("inside.bin", inner() / "good.bin");
        if (::mkfifo((inner() / "fifo.bin").c_str(), 0600) != 0) throw std::runtime_error("no FIFO");
    }
    fs::path inner() const { return root_.path() / "scene"; }

    /// What loading a scene says whose buffer, or whose picture, is at `uri`; after the pointer.
    std::string error_with(std::string const& uri, bool picture) const {
        GltfBuilder builder = one_triangle();
        if (picture) {
            builder.json["images"] = {{{"uri", uri}}};
            builder.json["textures"] = {{{"source", 0}}};
            builder.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
        } else {
            builder.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
        }
        write_text_file(inner() / "scene.gltf", builder.gltf());
        std::string message;
        Cost const cost = cost_of([&] {
            try {
                load_gltf(inner() / "scene.gltf");
            } catch (GltfError const& error) {
                EXPECT_EQ(error.diagnostic().pointer, picture ? "/images/0/uri" : "/buffers/0/uri");
                message = error.diagnostic().message;
            }
        });
        expect_cheap(cost, uri.substr(0, 100));
        return message;
    }

private:
    TemporaryFolder root_;
};

struct UriRow {
    char const* name;
    std::string uri, message; ///< the message's end
};

std::ostream& operator<<(std::ostream& out, UriRow const& row) { return out << row.name; }

std::string beside(std::string const& reason) { return reason + only_beside; }

class GltfUris : public testing::TestWithParam<UriRow> {};

std::vector<UriRow> const ROWS = {
    {"absolute_path", "/etc/passwd", beside("is an absolute path")},
    {"encoded_absolute_path", "%2Fetc%2Fpasswd", beside("is an absolute path")},
    {"two_slashes", "//host/share.bin", beside("is an absolute path")},
    {"drive", "C:/x.bin", "has a scheme; only data: and files beside the scene are read"},
    {"encoded_drive", "C%3A/x.bin", "has a scheme; only data: and files beside the scene are read"},
    {"file_scheme", "file:///etc/passwd", "has a scheme; only data: and files beside the scene are read"},
    {"http_scheme", "http://host/x.bin", "has a scheme; only data: and files beside the scene are read"},
    {"empty_scheme", ":x.bin", "has an empty scheme"},
    {"nothing", "", "is empty"},
    {"up", "../outside.bin", beside("goes up with \"..\"")},
    {"up_within", "a/../inside.bin", beside("goes up with \"..\"")},
    {"up_at_the_end", "a/..", beside("goes up with \"..\"")},
    {"encoded_up", "%2e%2E/outside.bin", beside("goes up with \"..\"")},
    {"encoded_slash", "..%2Foutside.bin", beside("goes up with \"..\"")},
    {"doubly_encoded_up", "%252e%252e/outside.bin", "No such file or directory (check the path)"},
    {"encoded_nul", "inside.bin%00.png", "holds a NUL"},
    {"nul", std::string("inside.bin\0.png", 15), "holds a NUL"},
    {"backslash", "a\\..\\inside.bin", "holds a backslash"},
    {"encoded_backslash", "..%5Coutside.bin", "holds a backslash"},
    {"link_to_a_file_outside", "link.bin", "leaves the scene's folder through a link"},
    {"link_to_a_folder_outside", "links/outside.bin", "leaves the scene's folder through a link"},
    {"link_to_a_device", "endless.bin", "leaves the scene's folder through a link"},
    {"link_to_itself", "loop.bin", "can't be looked up: Too many levels of symbolic links"},
    {"folder", "a", "is not a regular file (give the path of a file)"},
    {"own_folder", ".", "is not a regular file (give the path of a file)"},
    {"fifo", "fifo.bin", "is not a regular file (give the path of a file)"},
    {"missing", "missing.bin", "No such file or directory (check the path)"},
    {"file_as_folder", "inside.bin/x", "Not a directory (check the path)"},
    {"long", std::string(5000, 'x'), "is longer than 4096 bytes"},
    {"very_long", std::string(8 << 20, '/'), "is longer than 4096 bytes"},
    {"long_name", std::string(300, 'x'), "can't be looked up: File name too long"},
};

} // namespace

TEST_P(GltfUris, are_refused_without_a_look_at_the_file) {
    Folder const folder;
    for (bool const picture : {false, true}) {
        std::string const message = folder.error_with(GetParam().uri, picture);
        EXPECT_TRUE(message.ends_with(GetParam().message)) << message;
        EXPECT_LT(message.size(), 600u);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, GltfUris, testing::ValuesIn(ROWS), [](auto const& row) { return std::string(row.param.name); });

TEST(GltfUri, of_a_file_beside_the_scene_is_read) {
    Folder const folder;
    for (char const* const uri : {"inside.bin", "./insid%65.bin", "a/inside.bin", "good.bin", "a//inside.bin"})
        EXPECT_EQ(folder.error_with(uri, false), "") << uri;
}

TEST(GltfUri, of_a_device_is_refused) {
    Folder const folder;
    if (::mknod((folder.inner() / "device.bin").c_str(), S_IFCHR | 0600, ::makedev(1, 5)) != 0)
        GTEST_SKIP() << "devices can be made by root only";
    EXPECT_TRUE(folder.error_with("device.bin", false).ends_with("is not a regular file (give the path of a file)"));
}

TEST(GltfUri, scenes_that_are_no_files_are_refused_at_once) {
    Folder const folder;
    for (fs::path const& path : {fs::path("/dev/zero"), folder.inner(), folder.inner() / "fifo.bin"}) {
        Cost const cost = cost_of([&] { EXPECT_THROW(load_gltf(path), Error) << path; });
        expect_cheap(cost, path.string());
    }
}

TEST(GltfUri, what_it_holds_reaches_the_terminal_as_plain_text) {
    Folder const folder;
    std::string const message = folder.error_with("%1B]0;title%07%0A%ff.bin", false);
    for (char const c : message) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << message;
    EXPECT_NE(message.find("?.bin"), std::string::npos) << "a byte that is no UTF-8 becomes ?: " << message;
}
