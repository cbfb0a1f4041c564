#include "image/codec.h"
#include "support/cost.h"
#include "support/gltf_packed.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

// Small files that ask for much: time that grows with the square of their size, or memory in no proportion to it. Each
// is refused, or read, at little cost.

namespace {

std::string repeated(std::string const& text, int count) {
    std::string list;
    list.reserve((text.size() + 1) * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) (list += i == 0 ? "" : ",") += text;
    return list;
}

std::string document(std::string const& members) { return R"({"asset":{"version":"2.0"},)" + members + "}"; }

/// The error that loading gives, and that it gives it, or none, at once.
std::string cheap_error_of(std::string const& text) {
    std::string message;
    expect_cheap(cost_of([&] { message = error_of(text); }), text.substr(0, 80));
    return message;
}

void expect_refused(std::string const& text, std::string const& part) {
    std::string const message = cheap_error_of(text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// Bytes of a Draco mesh (edgebreaker) that announces so many vertices and faces, and nothing behind it.
std::string draco_announcement(std::uint32_t count) {
    std::string bytes("DRACO\2\2\1\1\0\0\0", 12);
    for (int number = 0; number < 2; ++number) {
        for (std::uint32_t rest = count; rest > 0; rest >>= 7) bytes += static_cast<char>((rest & 0x7F) | (rest > 0x7F ? 0x80 : 0));
    }
    return bytes + '\0';
}

std::vector<std::byte> as_bytes(std::string const& text) {
    auto const* const first = reinterpret_cast<std::byte const*>(text.data());
    return {first, first + text.size()};
}

} // namespace

TEST(GltfAttacks, lists_of_nothing_do_not_become_gigabytes) {
    expect_refused(document("\"materials\":[" + repeated("{}", 1'000'000) + "]"), "more than the limit of 65536");
    expect_refused(document("\"nodes\":[" + repeated("{}", 1'000'001) + "]"), "more than the limit of 1000000");
    expect_refused(document("\"meshes\":[{\"primitives\":[" + repeated("{}", 1'000'001) + "]}]"), "primitives, more than");
    expect_refused(document("\"extras\":[" + repeated("0", 8'000'000) + "]"), "more than the limit of 8000000");
}

TEST(GltfAttacks, long_names_are_not_copied_for_each_value_below_them) {
    std::string const name(4 << 20, 'x');
    EXPECT_EQ(cheap_error_of(document("\"" + name + "\":[" + repeated("{}", 200'000) + "]")), "");
    EXPECT_EQ(cheap_error_of(document("\"nodes\":[{\"name\":\"" + name + "\"}]")), "");
}

TEST(GltfAttacks, buffers_without_bytes_and_views_are_not_searched_for_each_other) {
    std::string const view = R"({"buffer":0,"byteLength":4})";
    expect_refused(document("\"buffers\":[" + repeated(R"({"byteLength":4})", 50'000) + "],\"bufferViews\":[" + repeated(view, 50'000) + "]"),
                   "/buffers/0: has no uri");
    std::string const last = R"({"buffer":49999,"byteLength":4})";
    expect_refused(document("\"buffers\":[" + repeated(R"({"byteLength":4})", 50'000) + "],\"bufferViews\":[" + repeated(last, 50'000) + "]"),
                   "/buffers/49999: has no uri");
}

TEST(GltfAttacks, sparse_accessors_that_share_their_bytes_are_not_read_one_by_one) {
    GltfBuilder builder = one_triangle();
    std::vector<std::uint16_t> places(30'000);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<std::uint16_t>(i);
    int const view = builder.add_view(places), values = builder.add_view(std::vector<std::uint8_t>(30'000));
    Json const sparse = {{"count", 30'000},
                         {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                         {"values", {{"bufferView", values}}}};
    for (int i = 0; i < 20'000; ++i) {
        int const accessor = builder.add_accessor(-1, 5121, 30'000, "SCALAR");
        builder.json["accessors"][accessor]["sparse"] = sparse;
    }
    expect_refused(builder.gltf(), "/accessors: read the buffers'");
}

TEST(GltfAttacks, morph_targets_that_share_an_accessor_count_each) {
    GltfBuilder builder;
    int const position = builder.add_accessor(-1, 5126, 60'000, "VEC3");
    Json const target = {{"POSITION", position}}, weight = 1;
    builder.show({{"POSITION", position}}, {{"targets", Json::array_t(20'000, target)}});
    builder.json["meshes"][0]["weights"] = Json::array_t(20'000, weight);
    expect_refused(builder.gltf(), "vertices in all, more than the limit of 16777216");
}

TEST(GltfAttacks, skinned_nodes_that_share_a_skin_count_each) {
    GltfBuilder builder = one_triangle();
    int const count = 3'000;
    Json joints = Json::array();
    for (int i = 0; i < count; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
        for (int k = 0; k < 4; ++k) joints.push_back(i + 1);
    }
    builder.json["skins"] = {{{"joints", joints}}};
    expect_refused(builder.gltf(), "vertices in all, more than the limit of 16777216");
}

TEST(GltfAttacks, what_is_left_out_counts_as_well) {
    GltfBuilder builder;
    Json const points = {{"mode", 0}, {"attributes", {{"POSITION", builder.add_accessor(-1, 5126, 1, "VEC3")}}}};
    builder.json["meshes"] = {{{"primitives", Json::array_t(5'000, points)}}};
    builder.json["skins"] = {{{"joints", {0}}}};
    for (int i = 0; i < 5'000; ++i) builder.json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
    expect_refused(builder.gltf(), "in all, more than the limit of");
}

TEST(GltfAttacks, draco_meshes_of_more_than_their_bytes_can_hold_are_not_unpacked) {
    GltfBuilder builder;
    std::uint32_t const count = 1'000'000'000;
    int const view = builder.add_view(as_bytes(draco_announcement(count)));
    int const positions = builder.add_accessor(-1, 5126, count, "VEC3"), indices = builder.add_accessor(-1, 5125, 3ull * count, "SCALAR");
    Json const extension = {{DRACO, {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}};
    builder.show({{"POSITION", positions}}, {{"indices", indices}, {"extensions", extension}});
    builder.json["extensionsUsed"] = {DRACO};
    expect_refused(builder.gltf(), "says 1000000000 vertices and 1000000000 triangles, more than 23 bytes can hold");
    builder.buffer.resize(2 << 20);
    builder.json["bufferViews"][0]["byteLength"] = 2 << 20;
    expect_refused(builder.gltf(), "unpacks 1000000000 vertices in all, more than the limit of 16777216");
}

TEST(GltfAttacks, the_same_draco_bytes_again_and_again_count_each_time) {
    GltfBuilder builder = packed_by_draco();
    Json const primitive = builder.json["meshes"][0]["primitives"][0];
    for (int i = 0; i < 1'000; ++i) builder.json["meshes"][0]["primitives"].push_back(primitive);
    GltfOptions options;
    options.limits.most_vertices = 1'000;
    EXPECT_NE(codes_of(builder.gltf(), options).find("LIMIT_EXCEEDED"), std::string::npos);
    EXPECT_EQ(error_of(builder.gltf()), "");
}

TEST(GltfAttacks, pictures_do_not_unpack_to_more_than_their_headers_say) {
    ByteImage const large({2048, 2048});
    std::vector<std::byte> bytes = encode_png(large);
    EXPECT_EQ(decode_picture(bytes).extent, large.extent);
    std::uint8_t const one[8] = {0, 0, 0, 1, 0, 0, 0, 1};
    std::memcpy(bytes.data() + 16, one, 8); // the header's width and height
    Cost const cost = cost_of([&] {
        try {
            decode_picture(bytes);
            ADD_FAILURE() << "16 MiB behind a header of one pixel were decoded";
        } catch (Error const& error) {
            EXPECT_STREQ(error.what(), "picture can't be decoded: it unpacks to more than its header says");
        }
    });
    EXPECT_LT(cost.mebibytes, 12);
}

TEST(GltfAttacks, progressive_pictures_have_few_scans) {
    std::vector<std::byte> bytes = encode_jpeg(ByteImage({64, 64}), 80);
    EXPECT_EQ(decode_picture(bytes).extent, (Extent{64, 64}));
    for (int i = 0; i < 256; ++i) bytes.insert(bytes.end(), {std::byte{0xFF}, std::byte{0xDA}});
    try {
        decode_picture(bytes);
        FAIL();
    } catch (Error const& error) {
        EXPECT_STREQ(error.what(), "picture can't be decoded: JPEG of 257 scans, 256 are read");
    }
}

TEST(GltfAttacks, bent_instances_count_each) {
    GltfBuilder builder;
    builder.show({{"POSITION", builder.add_accessor(-1, 5126, 60'000, "VEC3")}});
    for (int i = 1; i < 1'000; ++i) {
        builder.json["nodes"].push_back({{"mesh", 0}});
        builder.json["scenes"][0]["nodes"].push_back(i);
    }
    Scene scene = builder.load();
    expect_cheap(cost_of([&] {
                     try {
                         curve_to_planet(scene, 6.36e6, 1);
                         ADD_FAILURE();
                     } catch (Error const& error) {
                         EXPECT_STREQ(error.what(), "curve: each instance is bent by itself: 60000000 vertices in all, more than the limit of "
                                                    "16777216 (raise it with --set most_vertices=NUMBER, or place the scene without curve)");
                     }
                 }),
                 "curve");
}

TEST(GltfAttacks, numbers_that_overflow_on_the_way_to_a_vertex_are_refused) {
    GltfBuilder builder = one_triangle();
    int const far = builder.add<float>("VEC3", std::vector<float>(9, 3e38f));
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", far}}};
    builder.json["meshes"][0]["weights"] = {1e30};
    EXPECT_EQ(error_of(builder.gltf()), "/meshes/0/primitives/0: has a vertex that is moved out of a float's range");
}
