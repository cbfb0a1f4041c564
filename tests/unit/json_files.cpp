#include "scene/json_reader.h"
#include "support/files.h"

#include <random>

using namespace alpenglow;
using test::expect_error;

namespace {

void expect_refused(std::string const& text, std::vector<std::string> parts) {
    test::TemporaryFolder const folder;
    std::filesystem::path const file = folder.write("bad.json", text);
    parts.push_back("bad.json");
    expect_error(ErrorKind::bad_input, parts, [&] { json::File{file}; });
}

} // namespace

TEST(JsonFiles, what_is_not_json_is_refused) {
    expect_refused("", {"is not JSON", "line 1, column 1"});
    expect_refused("{\"a\": 1,}", {"is not JSON", "trailing commas"});
    expect_refused("{\n\"a\": NaN}", {"is not JSON", "line 2", "NaN"});
    expect_refused("{\"a\": 1e999}", {"is not JSON", "1e308"});
    expect_refused("{\"a\": 1} x", {"is not JSON"});
    expect_refused("{\"a\": \"\xff\xfe\"}", {"is not JSON", "UTF-8"});
    expect_refused("{\"a\": \"" + std::string(100000, 'x'), {"is not JSON"});
    expect_refused(std::string("\0\0\0", 3), {"is not JSON"});
}

TEST(JsonFiles, duplicate_keys_are_refused_at_any_depth) {
    expect_refused(R"({"a": 1, "b": 2, "a": 3})", {"key \"a\" stands twice"});
    expect_refused(R"([{"b": {"c": 1, "c": 1}}])", {"key \"c\" stands twice"});
    test::TemporaryFolder const folder;
    EXPECT_NO_THROW(json::File{folder.write("good.json", R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": 1}]})")});
}

TEST(JsonFiles, depth_and_size_are_bounded) {
    expect_refused(std::string(1'000'000, '['), {"nested more than 16"});
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    expect_refused(objects, {"nested more than 16"});
    expect_refused(std::string((4u << 20) + 1, ' '), {"more than the limit"});
}

TEST(JsonFiles, what_is_not_a_file_is_refused) {
    expect_error(ErrorKind::bad_input, {"/nonexistent.json", "No such file"}, [] { json::File{"/nonexistent.json"}; });
    expect_error(ErrorKind::bad_input, {"/tmp", "not a regular file"}, [] { json::File{"/tmp"}; });
    if (::geteuid() == 0) return; // root reads everything
    test::TemporaryFolder const folder;
    std::filesystem::path const file = folder.write("secret.json", "{}");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    expect_error(ErrorKind::bad_input, {"secret.json", "Permission denied"}, [&] { json::File{file}; });
}

TEST(JsonFiles, random_damage_is_refused_or_read_and_never_worse) {
    test::TemporaryFolder const folder;
    std::string const good = read_text_file(test::assets() / "planets/earth.json");
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        std::string bad = good;
        for (int n = 0; n < 3; ++n) bad[random() % bad.size()] = static_cast<char>(random() % 256);
        std::filesystem::path const file = folder.write("bad.json", bad);
        try {
            json::File const read(file);
        } catch (Error const& error) {
            EXPECT_EQ(error.exit_code(), 3);
        }
    }
}
