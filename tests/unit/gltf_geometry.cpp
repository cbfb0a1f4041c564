#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

std::vector<float> const square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
std::vector<float> const up = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};

/// Four vertices with normals, drawn with `indices` in `mode`.
template <class T> Mesh square_mesh(std::vector<T> const& indices, int mode) {
    GltfBuilder builder;
    Json const attributes = {{"POSITION", builder.add<float>("VEC3", square)}, {"NORMAL", builder.add<float>("VEC3", up)}};
    builder.show(attributes, {{"indices", builder.add<T>("SCALAR", indices)}, {"mode", mode}});
    return builder.load().meshes.at(0);
}

using Indices = std::vector<std::uint32_t>;

} // namespace

TEST(GltfGeometry, a_triangle_without_anything_else_gets_a_flat_normal_and_the_default_material) {
    Scene const scene = one_triangle().load();
    ASSERT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1));
    EXPECT_EQ(triangle_count(scene), 1u);
    for (Vertex const& vertex : scene.meshes[0].vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.bounds.lowest, glm::dvec3(0, 0, 0));
    EXPECT_EQ(scene.bounds.highest, glm::dvec3(1, 1, 0));
}

TEST(GltfGeometry, lists_strips_and_fans_wind_alike) {
    EXPECT_EQ(square_mesh<std::uint16_t>({0, 1, 2, 2, 1, 3}, 4).indices, (Indices{0, 1, 2, 2, 1, 3}));
    EXPECT_EQ(square_mesh<std::uint8_t>({0, 1, 2, 3}, 5).indices, (Indices{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(square_mesh<std::uint32_t>({0, 1, 3, 2}, 6).indices, (Indices{1, 3, 0, 3, 2, 0}));
}

TEST(GltfGeometry, degenerate_triangles_of_a_strip_are_dropped_and_count_for_the_winding) {
    EXPECT_EQ(square_mesh<std::uint16_t>({0, 1, 2, 2, 1, 3}, 5).indices, (Indices{0, 1, 2, 2, 3, 1}));
}

TEST(GltfGeometry, corners_that_make_no_whole_triangle_are_dropped) {
    EXPECT_EQ(square_mesh<std::uint16_t>({0, 1, 2, 3}, 4).indices, (Indices{0, 1, 2}));
}

TEST(GltfGeometry, points_and_lines_are_left_out) {
    for (int const mode : {0, 1, 2, 3}) {
        GltfBuilder builder;
        builder.show({{"POSITION", builder.add<float>("VEC3", square)}}, {{"mode", mode}});
        EXPECT_TRUE(builder.load().meshes.empty());
    }
}

TEST(GltfGeometry, flat_normals_split_shared_vertices_and_take_tangents_away) {
    GltfBuilder builder;
    int const positions = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    int const tangents = builder.add<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    int const indices = builder.add<std::uint16_t>("SCALAR", {0, 1, 2, 0, 3, 1});
    builder.show({{"POSITION", positions}, {"TANGENT", tangents}}, {{"indices", indices}});
    Mesh const mesh = builder.load().meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 6u);
    EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[3].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(0));
}

TEST(GltfGeometry, interleaved_attributes_are_read_with_their_stride_and_offset) {
    GltfBuilder builder;
    std::vector<float> const data = {0, 0, 0, 0, 0, 1, 0.5f, 0.25f, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 1};
    int const view = builder.add_view(data, 32);
    int const position = builder.add_accessor(view, 5126, 3, "VEC3");
    int const normal = builder.add_accessor(view, 5126, 3, "VEC3");
    int const uv = builder.add_accessor(view, 5126, 3, "VEC2");
    builder.json["accessors"][normal]["byteOffset"] = 12;
    builder.json["accessors"][uv]["byteOffset"] = 24;
    builder.show({{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}});
    Mesh const mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.vertices[0].uv0, glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(mesh.vertices[2].uv0, glm::vec2(0, 1));
}

TEST(GltfGeometry, sparse_values_replace_those_of_the_view_or_zeros) {
    for (bool const with_view : {true, false}) {
        GltfBuilder builder;
        int const view = with_view ? builder.add_view<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) : -1;
        int const position = builder.add_accessor(view, 5126, 3, "VEC3");
        int const places = builder.add_view<std::uint16_t>({1, 2}), values = builder.add_view<float>({5, 0, 0, 0, 6, 0});
        builder.json["accessors"][position]["sparse"] = {{"count", 2},
                                                         {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                                         {"values", {{"bufferView", values}}}};
        builder.show({{"POSITION", position}});
        Mesh const mesh = builder.load().meshes.at(0);
        EXPECT_EQ(mesh.vertices[0].position, glm::vec3(0));
        EXPECT_EQ(mesh.vertices[1].position, glm::vec3(5, 0, 0));
        EXPECT_EQ(mesh.vertices[2].position, glm::vec3(0, 6, 0));
    }
}

TEST(GltfGeometry, normalized_integers_follow_the_formats_rule) {
    GltfBuilder builder = one_triangle();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = builder.add<std::uint8_t>("VEC2", {0, 255, 51, 0, 0, 0}, true);
    attributes["TEXCOORD_1"] = builder.add<std::uint16_t>("VEC2", {0, 65535, 13107, 0, 0, 0}, true);
    builder.json["accessors"][1]["bufferView"] = builder.add_view<std::uint8_t>({0, 255, 0, 0, 51, 0, 0, 0, 0, 0, 0, 0}, 4);
    int const colors = builder.add_view<std::uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4);
    attributes["COLOR_0"] = builder.add_accessor(colors, 5121, 3, "VEC3", true);
    Mesh const mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.vertices[0].uv0, glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(mesh.vertices[1].uv0.x, 0.2f);
    EXPECT_FLOAT_EQ(mesh.vertices[1].uv1.x, 0.2f);
    EXPECT_EQ(mesh.vertices[0].color, glm::vec4(1, 0, 0.2f, 1)) << "a colour of three components is opaque";
    EXPECT_EQ(mesh.vertices[1].color, glm::vec4(0, 0, 0, 1));
}

TEST(GltfGeometry, colours_of_16_bits_and_of_floats_are_linear_and_clamped) {
    GltfBuilder builder = one_triangle();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["COLOR_0"] = builder.add<std::uint16_t>("VEC4", {65535, 0, 0, 13107, 0, 0, 0, 0, 0, 0, 0, 0}, true);
    EXPECT_EQ(builder.load().meshes.at(0).vertices[0].color, glm::vec4(1, 0, 0, 0.2f));
    attributes["COLOR_0"] = builder.add<float>("VEC4", {0.5f, 2, -1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(builder.load().meshes.at(0).vertices[0].color, glm::vec4(0.5f, 1, 0, 1));
}

TEST(GltfGeometry, quantized_attributes_need_their_extension) {
    GltfBuilder builder;
    int const view = builder.add_view<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}, 8);
    builder.show({{"POSITION", builder.add_accessor(view, 5122, 3, "VEC3", true)}});
    EXPECT_EQ(error_of(builder.gltf()), "/meshes/0/primitives/0/attributes/POSITION: POSITION has components of a type that "
                                        "it can't have (KHR_mesh_quantization would allow it)");
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    Mesh const mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[2].position, glm::vec3(0, -1, 0)) << "the most negative integer is -1 as well";
}

TEST(GltfGeometry, normals_and_tangents_come_out_as_units) {
    GltfBuilder builder = one_triangle();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add<float>("VEC3", {0, 0, 2, 0, 3, 4, 0, 0, 0});
    attributes["TANGENT"] = builder.add<float>("VEC4", {3, 0, 4, -1, 0, 0, 0, 1, 1, 0, 0, 1});
    Mesh const mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0.6f, 0.8f));
    EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 1, 0)) << "a normal of length 0";
    EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(0.6f, 0, 0.8f, -1));
    EXPECT_EQ(mesh.vertices[1].tangent, glm::vec4(0)) << "a tangent of length 0 counts as none";
}

TEST(GltfGeometry, parts_with_the_same_attributes_share_vertices_and_have_their_own_boxes) {
    GltfBuilder builder;
    Json const attributes = {{"POSITION", builder.add<float>("VEC3", square)}, {"NORMAL", builder.add<float>("VEC3", up)}};
    builder.show(attributes, {{"indices", builder.add<std::uint16_t>("SCALAR", {0, 1, 2})}});
    Json second = builder.json["meshes"][0]["primitives"][0];
    second["indices"] = builder.add<std::uint16_t>("SCALAR", {1, 3, 2});
    builder.json["meshes"][0]["primitives"].push_back(second);
    Mesh const mesh = builder.load().meshes.at(0);
    EXPECT_EQ(mesh.vertices.size(), 4u);
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[1].first_index, 3u);
    EXPECT_EQ(mesh.parts[0].bounds.highest, glm::dvec3(1, 1, 0));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 1, 3, 2}));
}

TEST(GltfGeometry, a_glb_is_known_by_its_content) {
    TemporaryFolder const folder;
    GltfBuilder const builder = one_triangle();
    write_text_file(folder.path() / "scene.gltf", builder.glb());
    EXPECT_EQ(load_gltf(folder.path() / "scene.gltf").meshes.at(0).vertices[1].position, glm::vec3(1, 0, 0));
}
