#include "image/codec.h"
#include "support/gltf_packed.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

#include <cstring>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

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
