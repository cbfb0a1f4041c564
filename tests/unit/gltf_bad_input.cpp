#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sys/stat.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

struct BadCase {
    char const* name;
    std::function<void(GltfBuilder&)> spoil;
    char const* message;
};

/// Sets the value at a JSON pointer.
std::function<void(GltfBuilder&)> set(char const* pointer, Json value) {
    return [pointer, value](GltfBuilder& b) { b.json[Json::json_pointer(pointer)] = value; };
}

std::function<void(GltfBuilder&)> with_indices(std::vector<std::uint16_t> indices) {
    return [indices](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["indices"] = b.add<std::uint16_t>("SCALAR", indices); };
}

std::function<void(GltfBuilder&)> with_sparse(std::vector<std::uint16_t> places) {
    return [places](GltfBuilder& b) {
        int const view = b.add_view(places), values = b.add_view(std::vector<float>(places.size() * 3));
        b.json["accessors"][0]["sparse"] = {{"count", places.size()},
                                            {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}};
    };
}

std::function<void(GltfBuilder&)> with_first_float(float value) {
    return [value](GltfBuilder& b) { std::memcpy(b.buffer.data(), &value, sizeof value); };
}

/// Of an error about a limit.
std::string advice(std::string const& setting) {
    return " (where the file is to be trusted, raise it with --set " + setting + "=NUMBER)";
}

} // namespace

// The triangle's buffer has 36 bytes, one view and one accessor of three positions.
TEST(GltfBadInput, names_the_place_and_the_reason) {
    float const nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<BadCase> const cases = {
        {"no asset", [](GltfBuilder& b) { b.json.erase("asset"); }, "/asset: is missing"},
        {"version 1", set("/asset/version", "1.0"), "/asset/version: glTF 1.0 is not supported (only glTF 2 is)"},
        {"no version", set("/asset/version", "two"), "/asset/version: \"two\" is not a version"},
        {"new version", set("/asset/minVersion", "2.1"), "/asset/minVersion: needs a reader of glTF 2.1 (this one reads 2.0)"},
        {"extension", set("/extensionsRequired", Json::array({"EXT_unknown"})),
         "/extensionsRequired/0: EXT_unknown is required and not supported (export the scene without it)"},
        {"wrong type", set("/nodes/0/mesh", "0"), "/nodes/0/mesh: must be an integer"},
        {"fraction", set("/accessors/0/count", 2.5), "/accessors/0/count: must be an integer"},
        {"object for array", set("/accessors", Json::object()), "/accessors: must be an array"},
        {"no objects", set("/nodes/0", 1), "/nodes/0: must be an object"},
        {"node's mesh", set("/nodes/0/mesh", 1), "/nodes/0/mesh: is 1, but there are 1 meshes"},
        {"negative index", set("/nodes/0/mesh", -1), "/nodes/0/mesh: is below 0"},
        {"child", set("/nodes/0/children", Json::array({7})), "/nodes/0/children/0: is 7, but there are 1 nodes"},
        {"scene", set("/scene", 1), "/scene: is 1, but there are 1 scenes"},
        {"material", set("/meshes/0/primitives/0/material", 0), "/meshes/0/primitives/0/material: is 0, but there are 0 materials"},
        {"mode", set("/meshes/0/primitives/0/mode", 7), "/meshes/0/primitives/0/mode: is above 6"},
        {"attribute", set("/meshes/0/primitives/0/attributes/POSITION", 9),
         "/meshes/0/primitives/0/attributes/POSITION: is 9, but there are 1 accessors"},
        {"no primitives", set("/meshes/0/primitives", Json::array()), "/meshes/0/primitives: must be an array that is not empty"},
        {"buffer", set("/bufferViews/0/buffer", 3), "/bufferViews/0/buffer: is 3, but there are 1 buffers"},
        {"view too long", set("/bufferViews/0/byteLength", 37), "/bufferViews/0: 37 bytes from 0 reach beyond its buffer of 36 bytes"},
        {"view overflow", set("/bufferViews/0/byteOffset", 9007199254740992),
         "/bufferViews/0: 36 bytes from 9007199254740992 reach beyond its buffer of 36 bytes"},
        {"stride", set("/bufferViews/0/byteStride", 256), "/bufferViews/0/byteStride: is above 252"},
        {"short stride", set("/bufferViews/0/byteStride", 8), "/accessors/0: elements of 12 bytes don't fit its view's stride of 8 bytes"},
        {"count", set("/accessors/0/count", 4), "/accessors/0: 4 elements from byte 0 reach beyond its view of 36 bytes"},
        {"huge count", set("/accessors/0/count", 9007199254740992),
         "/accessors/0: 9007199254740992 elements from byte 0 reach beyond its view of 36 bytes"},
        {"offset", set("/accessors/0/byteOffset", 40), "/accessors/0: 3 elements from byte 40 reach beyond its view of 36 bytes"},
        {"alignment", set("/accessors/0/byteOffset", 2), "/accessors/0: is not aligned to its components of 4 bytes"},
        {"zeros", [](GltfBuilder& b) { b.json["accessors"][0].erase("bufferView"), b.json["accessors"][0]["count"] = 1e9; },
         "/accessors/0/count: is 1000000000, more than all buffers have bytes"},
        {"component", set("/accessors/0/componentType", 5124),
         "/accessors/0/componentType: \"5124\" is not one of 5120|5121|5122|5123|5125|5126"},
        {"vector", set("/accessors/0/type", "VEC5"),
         "/accessors/0/type: \"VEC5\" is not one of SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"},
        {"normalized floats", set("/accessors/0/normalized", true),
         "/accessors/0/normalized: is true, but its components are not 8 or 16 bits"},
        {"form", set("/accessors/0/type", "VEC2"),
         "/meshes/0/primitives/0/attributes/POSITION: POSITION has the wrong number of components"},
        {"index", with_indices({0, 1, 3}), "/accessors/1: index 2 is 3, but there are 3 vertices"},
        {"restart", with_indices({0, 65535, 2}), "/accessors/1: index 1 is the restart value 65535"},
        {"indices", set("/meshes/0/primitives/0/indices", 0), "/meshes/0/primitives/0/indices: can't be indices: these are unsigned scalars, not normalized"},
        {"sparse order", with_sparse({1, 1}), "/accessors/0/sparse/indices: must increase strictly"},
        {"sparse range", with_sparse({1, 3}), "/accessors/0/sparse/indices: holds an index beyond the accessor's count"},
        {"sparse count", with_sparse({0, 1, 2, 3}), "/accessors/0/sparse/count: is above the accessor's count"},
        {"counts", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = b.add<float>("VEC3", {0, 0, 1}); },
         "/meshes/0/primitives/0/attributes/NORMAL: has 1 elements, POSITION 3"},
        {"not a number", with_first_float(nan), "/accessors/0: element 0 is not finite"},
        {"infinity", with_first_float(INFINITY), "/accessors/0: element 0 is not finite"},
        {"factor", set("/materials", Json::array({{{"emissiveFactor", {0, 0, 2}}}})), "/materials/0/emissiveFactor: is above 1"},
        {"matrix", set("/nodes/0/matrix", Json::array({1, 0})), "/nodes/0/matrix: must be an array of 16 numbers"},
        {"no float", set("/nodes/0/translation", Json::array({1e300, 0, 0})), "/nodes/0/translation: is too large for a float"},
        {"no uri", set("/buffers", Json::array({{{"byteLength", 36}}})), "/buffers/0: has no uri, and is not the binary chunk of a .glb"},
        {"short buffer", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "data:;base64,AAAA"}}})),
         "/buffers/0/byteLength: is 36, but there are 3 bytes"},
        {"base64", set("/buffers", Json::array({{{"byteLength", 36}, {"uri", "data:;base64,A?AA"}}})),
         "/buffers/0/uri: is not a valid data URI"},
        {"two sources", set("/images", Json::array({{{"uri", "a.png"}, {"bufferView", 0}}})),
         "/images/0: must have either a uri or a bufferView"},
    };
    for (BadCase const& bad : cases) {
        GltfBuilder builder = one_triangle();
        bad.spoil(builder);
        EXPECT_EQ(error_of(builder.gltf()), bad.message) << bad.name;
    }
}

TEST(GltfBadInput, text_that_is_not_gltf) {
    EXPECT_EQ(error_of("[1, 2]"), "is not glTF: its JSON is not an object");
    EXPECT_TRUE(error_of("").starts_with("is not glTF: parse error at line 1, column 1")) << error_of("");
    EXPECT_TRUE(error_of("solid stl").starts_with("is not glTF: parse error")) << error_of("solid stl");
    EXPECT_TRUE(error_of("{\"a\": 1e999}").starts_with("is not glTF: number overflow")) << error_of("{\"a\": 1e999}");
}

TEST(GltfBadInput, nesting_is_limited_before_anything_recurses) {
    std::string const deep(1'000'000, '[');
    EXPECT_EQ(error_of("{\"extras\": " + deep), "JSON is nested deeply, more than the limit of 100" + advice("deepest_json"));
    GltfBuilder builder = one_triangle();
    builder.json["extras"] = Json::parse(std::string(99, '[') + std::string(99, ']'));
    EXPECT_EQ(error_of(builder.gltf()), "");
    builder.json["extras"] = "[[[ in a text, \\\" too " + std::string(200, '[');
    EXPECT_EQ(error_of(builder.gltf()), "");
}

TEST(GltfBadInput, broken_containers) {
    std::string const good = one_triangle().glb();
    auto const with_word = [&](std::size_t offset, std::uint32_t word) {
        std::string bad = good;
        std::memcpy(bad.data() + offset, &word, 4);
        return error_of(bad);
    };
    EXPECT_EQ(error_of(good), "");
    EXPECT_EQ(error_of(good.substr(0, 8)), "GLB shorter than its header");
    EXPECT_EQ(with_word(4, 1), "GLB version 1 is not supported (only version 2 is)");
    std::string const size = std::to_string(good.size());
    EXPECT_EQ(with_word(8, 0xffffffff), "GLB header says 4294967295 bytes, the file has " + size);
    EXPECT_EQ(with_word(12, 0xffffffff), "GLB chunk of 4294967295 bytes, but only " + std::to_string(good.size() - 20) + " are left");
    EXPECT_EQ(with_word(16, 0), "GLB does not begin with a JSON chunk");
    EXPECT_EQ(with_word(8, 16), "GLB ends in the middle of a chunk's header");
}

TEST(GltfBadInput, files_are_read_from_the_scenes_folder_only) {
    TemporaryFolder const outside, folder;
    std::vector<std::byte> const bytes(36);
    write_file(outside.path() / "outside.bin", bytes);
    write_file(folder.path() / "inside.bin", bytes);
    std::filesystem::create_symlink(outside.path() / "outside.bin", folder.path() / "link.bin");
    std::filesystem::create_directory_symlink(outside.path(), folder.path() / "links");
    std::filesystem::create_symlink("inside.bin", folder.path() / "good.bin");
    ASSERT_EQ(::mkfifo((folder.path() / "fifo.bin").c_str(), 0600), 0);
    auto const error_with = [&](std::string const& uri) -> std::string {
        GltfBuilder builder = one_triangle();
        builder.json["buffers"] = Json::array({{{"byteLength", 36}, {"uri", uri}}});
        write_text_file(folder.path() / "scene.gltf", builder.gltf());
        try {
            load_gltf(folder.path() / "scene.gltf");
        } catch (Error const& error) {
            std::string const line = without_usual_advice(error.what());
            return line.substr(line.find("/buffers/0/uri: ") + 16);
        }
        return "";
    };
    auto const expect_refused = [&](std::string const& uri, std::string const& reason) {
        EXPECT_EQ(error_with(uri), "\"" + uri + "\" " + reason);
    };
    EXPECT_EQ(error_with("inside.bin"), "");
    EXPECT_EQ(error_with("./insid%65.bin"), "");
    EXPECT_EQ(error_with("good.bin"), "") << "a link that stays inside";
    std::string const absolute = (outside.path() / "outside.bin").string();
    expect_refused(absolute, "is an absolute path; only files beside the scene are read");
    expect_refused("%2Fetc%2Fpasswd", "is an absolute path; only files beside the scene are read");
    expect_refused("../outside.bin", "goes up with \"..\"; only files beside the scene are read");
    expect_refused("a/%2e%2E/inside.bin", "goes up with \"..\"; only files beside the scene are read");
    expect_refused("a\\..\\inside.bin", "holds a backslash");
    expect_refused("inside.bin%00.png", "holds a NUL");
    expect_refused("file://" + absolute, "has a scheme; only data: and files beside the scene are read");
    expect_refused("C%3A/x.bin", "has a scheme; only data: and files beside the scene are read");
    expect_refused("link.bin", "leaves the scene's folder through a link");
    expect_refused("links/outside.bin", "leaves the scene's folder through a link");
    EXPECT_TRUE(error_with("%252e%252e/inside.bin").ends_with("No such file or directory (check the path)")) << "decoded once";
    EXPECT_TRUE(error_with("missing.bin").ends_with("No such file or directory (check the path)"));
    EXPECT_TRUE(error_with("fifo.bin").ends_with("is not a regular file (give the path of a file)"));
}

TEST(GltfBadInput, pictures_are_refused_before_they_are_decoded) {
    GltfBuilder builder = one_triangle();
    builder.json["materials"] = Json::array({{{"normalTexture", {{"index", 0}}}}});
    builder.json["textures"] = Json::array({{{"source", 0}}});
    builder.json["images"] = Json::array({{{"uri", "data:image/png;base64,AAAA"}}});
    EXPECT_TRUE(error_of(builder.gltf()).starts_with("/images/0: picture can't be decoded")) << error_of(builder.gltf());
    // A PNG header of 16400 x 100 with nothing behind it.
    std::vector<std::uint8_t> const header = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R',
                                              0, 0, 0x40, 0x10, 0, 0, 0, 100, 8, 6, 0, 0, 0, 0, 0, 0, 0};
    builder.json["images"][0]["uri"] = "data:image/png;base64," + base64(std::as_bytes(std::span(header)));
    EXPECT_EQ(error_of(builder.gltf()), "/images/0: is a picture of 16400 x 100 texels, more than the limit of 16384" +
                                            advice("largest_picture"));
}

TEST(GltfBadInput, a_small_file_cannot_ask_for_a_huge_scene) {
    GltfBuilder builder;
    int const position = builder.add_accessor(-1, 5126, 65000, "VEC3");
    Json const primitive = {{"attributes", {{"POSITION", position}}}};
    builder.show({{"POSITION", position}});
    builder.json["meshes"][0]["primitives"] = Json::array();
    for (int i = 0; i < 2000; ++i) builder.json["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_NE(error_of(builder.gltf()).find("more than the limit of 16777216"), std::string::npos) << error_of(builder.gltf());
}

TEST(GltfBadInput, buffers_without_bytes_are_refused_only_where_something_reads_them) {
    GltfBuilder builder = one_triangle();
    nlohmann::json json = nlohmann::json::parse(builder.gltf());
    json["buffers"].push_back({{"byteLength", 8}});
    EXPECT_EQ(error_of(json.dump()), "");
    json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 8}});
    EXPECT_EQ(error_of(json.dump()), "/buffers/1: has no uri, and is not the binary chunk of a .glb");
}
