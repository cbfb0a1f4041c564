#include "image/codec.h"
#include "support/deep_png.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

ByteImage gradient(std::uint32_t width, std::uint32_t height) {
    ByteImage image({width, height});
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            std::uint8_t* const pixel = image.at(x, y);
            pixel[0] = static_cast<std::uint8_t>(x * 10), pixel[1] = static_cast<std::uint8_t>(y * 10), pixel[2] = 7, pixel[3] = 255;
        }
    }
    return image;
}

std::string png_uri(std::uint32_t width, std::uint32_t height) {
    return "data:image/png;base64," + base64(encode_png(gradient(width, height)));
}

/// A triangle with `material`, two textures: the first with a sampler, the second without.
GltfBuilder with_material(Json const& material) {
    GltfBuilder builder = one_triangle();
    builder.json["images"] = Json::array({{{"uri", png_uri(4, 2)}, {"name", "first"}}, {{"uri", png_uri(2, 2)}, {"name", "second"}}});
    builder.json["samplers"] = Json::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9729}}});
    builder.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}, {{"source", 1}}});
    builder.json["materials"] = Json::array({material});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

} // namespace

TEST(GltfMaterials, factors_and_switches) {
    Scene const scene = with_material({{"name", "rock"},
                                       {"pbrMetallicRoughness",
                                        {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}},
                                       {"emissiveFactor", {0, 0.5, 1}},
                                       {"alphaMode", "MASK"},
                                       {"alphaCutoff", 0.75},
                                       {"doubleSided", true}})
                            .load();
    ASSERT_EQ(scene.materials.size(), 1u);
    Material const& material = scene.materials[0];
    EXPECT_EQ(material.name, "rock");
    EXPECT_EQ(material.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.5f);
    EXPECT_EQ(material.roughness, 0.25f);
    EXPECT_EQ(material.emission, glm::vec3(0, 0.5f, 1));
    EXPECT_TRUE(material.alpha_mask);
    EXPECT_EQ(material.alpha_cutoff, 0.75f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_FALSE(material.base_color_texture);
    EXPECT_TRUE(scene.pictures.empty()) << "pictures that nothing uses are not decoded";
}

TEST(GltfMaterials, blended_ones_become_masked) {
    Scene const scene = with_material({{"alphaMode", "BLEND"}, {"alphaCutoff", 0.9}}).load();
    EXPECT_TRUE(scene.materials[0].alpha_mask);
    EXPECT_EQ(scene.materials[0].alpha_cutoff, 0.5f) << "the cutoff belongs to MASK alone";
    EXPECT_FALSE(with_material({{"alphaMode", "OPAQUE"}}).load().materials[0].alpha_mask);
}

TEST(GltfMaterials, five_textures_with_their_samplers_and_coordinates) {
    Json const first = {{"index", 0}}, second = {{"index", 1}, {"texCoord", 1}};
    Json normal = second, occlusion = first;
    normal["scale"] = 0.5, occlusion["strength"] = 0.25;
    Scene const scene = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", second}, {"metallicRoughnessTexture", first}}},
                                       {"normalTexture", normal},
                                       {"occlusionTexture", occlusion},
                                       {"emissiveTexture", second}})
                            .load();
    Material const& material = scene.materials[0];
    ASSERT_EQ(scene.pictures.size(), 2u) << "each picture is decoded once";
    EXPECT_EQ(scene.pictures[material.base_color_texture.picture].name, "second");
    EXPECT_EQ(scene.pictures[material.emission_texture.picture].name, "second");
    EXPECT_EQ(scene.pictures[material.metallic_roughness_texture.picture].name, "first");
    EXPECT_EQ(scene.pictures[material.occlusion_texture.picture].name, "first");
    EXPECT_EQ(material.normal_texture.uv_set, 1);
    EXPECT_EQ(material.occlusion_texture.uv_set, 0);
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(material.occlusion_strength, 0.25f);

    Texture const& sampled = material.metallic_roughness_texture;
    EXPECT_EQ(sampled.wrap_u, TextureWrap::clamp);
    EXPECT_EQ(sampled.wrap_v, TextureWrap::mirror);
    EXPECT_EQ(sampled.magnify, TextureFilter::nearest);
    EXPECT_EQ(sampled.minify, TextureFilter::linear);
    EXPECT_FALSE(sampled.mipmaps);
    Texture const& plain = material.base_color_texture;
    EXPECT_EQ(plain.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(plain.magnify, TextureFilter::linear);
    EXPECT_TRUE(plain.mipmaps);

    Picture const& picture = scene.pictures[sampled.picture];
    EXPECT_EQ(picture.width, 4u);
    EXPECT_EQ(picture.height, 2u);
    EXPECT_EQ(picture.rgba[4 * 7], 30) << "the last texel, as stored";
}

TEST(GltfMaterials, pictures_from_a_buffer_view_and_from_a_file_beside_the_scene) {
    GltfBuilder builder = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                         {"normalTexture", {{"index", 1}}}});
    builder.json["images"][0] = {{"bufferView", builder.add_view(encode_png(gradient(3, 3)))}, {"mimeType", "image/png"}};
    builder.json["images"][1] = {{"uri", "a%20b+c.png"}};
    TemporaryFolder const folder;
    write_png(folder.path() / "a b+c.png", gradient(5, 5));
    write_text_file(folder.path() / "scene.gltf", builder.gltf());
    Scene const scene = load_gltf(folder.path() / "scene.gltf");
    EXPECT_EQ(scene.pictures.at(0).width, 3u);
    EXPECT_EQ(scene.pictures.at(1).width, 5u);
}

TEST(GltfMaterials, large_pictures_are_halved_until_they_fit) {
    GltfBuilder builder = with_material({{"normalTexture", {{"index", 0}}}});
    builder.json["images"][0] = {{"uri", png_uri(16, 4)}};
    Scene const scene = builder.load({.largest_texture = 5});
    ASSERT_EQ(scene.pictures.size(), 1u);
    EXPECT_EQ(scene.pictures[0].width, 4u);
    EXPECT_EQ(scene.pictures[0].height, 1u);
    // 16 columns of 0, 10, 20, …: halved to 5, 25, …, then to 15, 55, …; the four rows to 15.
    EXPECT_EQ(scene.pictures[0].rgba, (std::vector<std::uint8_t>{15, 15, 7, 255, 55, 15, 7, 255, 95, 15, 7, 255, 135, 15, 7, 255}));
}

TEST(GltfMaterials, colours_are_halved_as_light) {
    GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}}}, {"normalTexture", {{"index", 1}}}});
    ByteImage checkers({2, 1});
    checkers.rgba = {255, 0, 0, 255, 0, 0, 0, 0};
    std::string const uri = "data:image/png;base64," + base64(encode_png(checkers));
    builder.json["images"] = Json::array({{{"uri", uri}}, {{"uri", uri}}});
    Scene const scene = builder.load({.largest_texture = 1});
    // Half of white's light is 188 in sRGB; alpha is no colour.
    EXPECT_EQ(scene.pictures.at(scene.materials[0].emission_texture.picture).rgba, (std::vector<std::uint8_t>{188, 0, 0, 128}));
    EXPECT_EQ(scene.pictures.at(scene.materials[0].normal_texture.picture).rgba, (std::vector<std::uint8_t>{128, 0, 0, 128}));
}

TEST(GltfMaterials, sixteen_bits_stay_sixteen) {
    GltfBuilder builder = with_material({{"emissiveTexture", {{"index", 0}}}, {"normalTexture", {{"index", 1}}}});
    auto const uri = [](DeepImage const& image) { return "data:image/png;base64," + base64(deep_png(image)); };
    DeepImage const gradient = deep_gradient({4, 1}, 30000, 100);
    DeepImage checkers({2, 1});
    checkers.rgba = {65535, 65535, 65535, 65535, 0, 0, 0, 65535};
    builder.json["images"] = Json::array({{{"uri", uri(checkers)}}, {{"uri", uri(gradient)}}});

    Scene const whole = builder.load();
    Picture const& picture = whole.pictures.at(whole.materials[0].normal_texture.picture);
    EXPECT_EQ(picture.rgba16, gradient.rgba);
    EXPECT_TRUE(picture.rgba.empty());

    Scene const small = builder.load({.largest_texture = 1});
    EXPECT_EQ(small.pictures.at(small.materials[0].normal_texture.picture).rgba16,
              (std::vector<std::uint16_t>{30150, 30150, 30150, 65535}));
    // 1.055 * 0.5^(1 / 2.4) - 0.055 = 0.735357
    std::uint16_t const half = 48192;
    EXPECT_EQ(small.pictures.at(small.materials[0].emission_texture.picture).rgba16,
              (std::vector<std::uint16_t>{half, half, half, 65535}));
}

TEST(GltfMaterials, pictures_in_all_are_limited) {
    GltfBuilder builder = with_material({{"normalTexture", {{"index", 0}}}, {"emissiveTexture", {{"index", 1}}}});
    builder.json["images"] = Json::array({{{"uri", png_uri(512, 512)}}, {{"uri", png_uri(512, 511)}}});
    GltfOptions options;
    options.limits.most_picture_memory = 1; // a picture of 512 x 512 takes it all
    EXPECT_TRUE(codes_of(builder.gltf(), options).ends_with("refused LIMIT_EXCEEDED"));
    options.largest_texture = 256;
    EXPECT_EQ(builder.load(options).pictures.size(), 2u) << "what counts is what stays after scaling";
}

TEST(GltfMaterials, the_line_about_a_scaled_picture_names_the_setting) {
    GltfBuilder builder = with_material({{"normalTexture", {{"index", 0}}}});
    builder.json["images"][0] = {{"uri", png_uri(16, 4)}};
    GltfSummary summary;
    load_text(builder.gltf(), {.largest_texture = 5}, &summary);
    EXPECT_EQ(summary.warnings.back().message, "/images/0 of 16 x 4 is scaled down to 4 x 1 (setting largest_texture)");
}

TEST(GltfMaterials, the_default_material_stands_after_the_files_own) {
    GltfBuilder builder = with_material(Json::object());
    Json plain = builder.json["meshes"][0]["primitives"][0];
    plain.erase("material");
    builder.json["meshes"][0]["primitives"].push_back(plain);
    Scene const scene = builder.load();
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.meshes[0].parts[0].material, 0u);
    EXPECT_EQ(scene.meshes[0].parts[1].material, 1u);
}
