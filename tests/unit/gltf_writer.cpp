#include "terrain/gltf_writer.h"

#include "support/files.h"

using namespace alpenglow;

TEST(GltfWriter, leaves_no_part_behind_where_one_cannot_be_written) {
    test::TemporaryFolder const folder;
    std::filesystem::create_directories(folder.path() / "t.bin/in_the_way");
    GltfWriter writer;
    writer.add_picture("rock", "png", std::vector<std::byte>(8));
    writer.add_view(std::vector<std::byte>(8));
    test::expect_error(ErrorKind::bad_input, {"t.bin"}, [&] { writer.write(folder.path() / "t.gltf"); });
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "t_rock.png"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "t.gltf"));
}
