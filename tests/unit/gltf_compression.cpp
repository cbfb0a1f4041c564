#include "image/codec.h"
#include "support/gltf_builder.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <cstring>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

std::vector<float> const CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 2};
std::vector<std::uint32_t> const INDICES = {0, 1, 2, 2, 1, 3};

std::string const MESHOPT = "EXT_meshopt_compression", DRACO = "KHR_draco_mesh_compression";

/// A view of `length` bytes in the fallback buffer whose compressed bytes are `bytes`.
int add_compressed(GltfBuilder& builder, std::vector<unsigned char> const& bytes, std::size_t count, std::size_t stride,
                   std::string const& mode) {
    int const view = builder.add_view(bytes);
    Json& json = builder.json["bufferViews"][static_cast<std::size_t>(view)];
    Json const extension = {{"buffer", 0},       {"byteOffset", json["byteOffset"]}, {"byteLength", bytes.size()},
                            {"byteStride", stride}, {"count", count},                {"mode", mode}};
    json = {{"buffer", 1}, {"byteLength", count * stride}, {"extensions", {{MESHOPT, extension}}}};
    return view;
}

/// Two triangles, as meshoptimizer packs them; the second buffer has no bytes.
GltfBuilder packed_by_meshopt() {
    GltfBuilder builder;
    std::vector<unsigned char> corners(meshopt_encodeVertexBufferBound(4, 12));
    corners.resize(meshopt_encodeVertexBuffer(corners.data(), corners.size(), CORNERS.data(), 4, 12));
    std::vector<unsigned char> triangles(meshopt_encodeIndexBufferBound(6, 4));
    triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), INDICES.data(), 6));
    int const positions = builder.add_accessor(add_compressed(builder, corners, 4, 12, "ATTRIBUTES"), 5126, 4, "VEC3");
    int const indices = builder.add_accessor(add_compressed(builder, triangles, 6, 4, "TRIANGLES"), 5125, 6, "SCALAR");
    builder.show({{"POSITION", positions}}, {{"indices", indices}});
    std::string const uri = "data:application/octet-stream;base64," + base64(builder.buffer);
    builder.json["buffers"] = {{{"byteLength", builder.buffer.size()}, {"uri", uri}},
                               {{"byteLength", 72}, {"extensions", {{MESHOPT, {{"fallback", true}}}}}}};
    builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {MESHOPT};
    return builder;
}

std::vector<char> draco_bytes(int& id) {
    draco::TriangleSoupMeshBuilder soup;
    soup.Start(2);
    id = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::size_t t = 0; t < 2; ++t) {
        auto const corner = [&](std::size_t i) { return &CORNERS[3 * INDICES[3 * t + i]]; };
        soup.SetAttributeValuesForFace(id, draco::FaceIndex(static_cast<std::uint32_t>(t)), corner(0), corner(1), corner(2));
    }
    std::unique_ptr<draco::Mesh> const mesh = soup.Finalize();
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(draco::Encoder().EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.data() + buffer.size()};
}

GltfBuilder packed_by_draco() {
    GltfBuilder builder;
    int id = 0;
    int const view = builder.add_view(draco_bytes(id));
    Json const extension = {{"bufferView", view}, {"attributes", {{"POSITION", id}}}};
    int const positions = builder.add_accessor(-1, 5126, 4, "VEC3");
    int const indices = builder.add_accessor(-1, 5123, 6, "SCALAR");
    builder.show({{"POSITION", positions}}, {{"indices", indices}, {"extensions", {{DRACO, extension}}}});
    builder.json["extensionsRequired"] = builder.json["extensionsUsed"] = {DRACO};
    return builder;
}

/// The triangles' mean height and the extent tell the square with one lifted corner from any other.
void expect_square(Scene const& scene) {
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(triangle_count(scene), 2u);
    EXPECT_EQ(scene.bounds.lowest, glm::dvec3(0));
    EXPECT_EQ(scene.bounds.highest, glm::dvec3(1, 1, 2));
    std::size_t lifted = 0;
    for (std::uint32_t const index : scene.meshes[0].indices) lifted += scene.meshes[0].vertices[index].position.z == 2;
    EXPECT_EQ(lifted, 1u);
}

} // namespace

TEST(GltfCompression, meshopt_views_are_unpacked) { expect_square(packed_by_meshopt().load()); }

TEST(GltfCompression, meshopt_headers_are_checked) {
    auto const error = [](std::string const& name, Json const& value) {
        GltfBuilder builder = packed_by_meshopt();
        builder.json["bufferViews"][0]["extensions"][MESHOPT][name] = value;
        return error_of(builder.gltf());
    };
    std::string const at = "/bufferViews/0/extensions/EXT_meshopt_compression";
    EXPECT_EQ(error("byteStride", 10), at + "/byteStride: is 10, which its mode and filter can't have");
    EXPECT_EQ(error("count", 5), at + "/count: 5 elements of 12 bytes don't fill its view of 48");
    EXPECT_EQ(error("mode", "MAGIC"), at + "/mode: \"MAGIC\" is not known");
    EXPECT_EQ(error("filter", "OCTAHEDRAL"), at + "/byteStride: is 12, which its mode and filter can't have");
    EXPECT_EQ(error("byteLength", 3), at + ": its bytes can't be decompressed");
    EXPECT_TRUE(error("byteLength", 1 << 20).starts_with(at + "/byteLength: 1048576 bytes from 0 reach beyond"));
    EXPECT_TRUE(error("buffer", 9).starts_with(at + "/buffer: "));
}

TEST(GltfCompression, meshopt_views_hold_no_more_than_their_bytes_can) {
    GltfBuilder builder = packed_by_meshopt();
    builder.json["bufferViews"][0]["byteLength"] = 12'000'000;
    builder.json["bufferViews"][0]["extensions"][MESHOPT]["count"] = 1'000'000;
    EXPECT_NE(error_of(builder.gltf()).find("is 1000000, more than"), std::string::npos);
}

TEST(GltfCompression, draco_primitives_are_unpacked) { expect_square(packed_by_draco().load()); }

TEST(GltfCompression, draco_streams_must_be_what_the_accessors_say) {
    GltfBuilder more = packed_by_draco();
    more.json["accessors"][1]["count"] = 9;
    std::string const at = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
    EXPECT_EQ(error_of(more.gltf()), at + ": holds 4 vertices and 2 triangles, the primitive's accessors say 4 and 3");
    GltfBuilder broken = packed_by_draco();
    broken.buffer[1] = std::byte{0};
    EXPECT_EQ(error_of(broken.gltf()), at + "/bufferView: is not a Draco 2.2 mesh");
    GltfBuilder short_one = packed_by_draco();
    short_one.json["bufferViews"][0]["byteLength"] = 20;
    EXPECT_TRUE(error_of(short_one.gltf()).starts_with(at + ": its bytes can't be decompressed"));
    GltfBuilder other = packed_by_draco();
    other.json["meshes"][0]["primitives"][0]["extensions"][DRACO]["attributes"]["POSITION"] = 77;
    EXPECT_EQ(error_of(other.gltf()), at + "/attributes/POSITION: there is no Draco attribute 77");
}

TEST(GltfCompression, webp_goes_before_the_core_picture) {
    std::vector<std::uint8_t> const rgba = {10, 20, 30, 255, 200, 100, 50, 128};
    std::uint8_t* encoded = nullptr;
    std::size_t const size = WebPEncodeLosslessRGBA(rgba.data(), 2, 1, 8, &encoded);
    std::vector<std::byte> const bytes(reinterpret_cast<std::byte*>(encoded), reinterpret_cast<std::byte*>(encoded) + size);
    WebPFree(encoded);
    GltfBuilder builder = one_triangle();
    builder.json["images"] = Json::array({{{"uri", "missing.png"}}, {{"uri", "data:image/webp;base64," + base64(bytes)}}});
    builder.json["textures"] = Json::array({{{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}}});
    builder.json["materials"] = Json::array({{{"emissiveTexture", {{"index", 0}}}}});
    Scene const scene = builder.load();
    ASSERT_EQ(scene.pictures.size(), 1u);
    EXPECT_EQ(scene.pictures[0].width, 2u);
    EXPECT_EQ(scene.pictures[0].rgba, rgba);
    EXPECT_THROW(decode_picture(std::span(bytes).first(size - 8)), Error);
    EXPECT_THROW(read_picture_header(std::span(bytes).first(16)), Error);
}
