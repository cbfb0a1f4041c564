#include "scene/gltf.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

GltfBuilder with_material(Json const& material) {
    GltfBuilder builder = one_triangle();
    builder.json["materials"] = Json::array({material});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

Material material_with(Json const& extensions) {
    return with_material({{"emissiveFactor", {1, 0.5, 0}}, {"extensions", extensions}}).load().materials.at(0);
}

std::string const ONE_PIXEL = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAA"
                              "AABJRU5ErkJggg==";

Texture texture_with(Json const& transform) {
    Json const info = {{"index", 0}, {"texCoord", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
    GltfBuilder builder = with_material({{"emissiveTexture", info}});
    builder.json["images"] = Json::array({{{"uri", ONE_PIXEL}}});
    builder.json["textures"] = Json::array({{{"source", 0}}});
    return builder.load().materials.at(0).emission_texture;
}

} // namespace

TEST(GltfExtensions, emission_may_be_strong) {
    EXPECT_EQ(material_with({{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}}).emission, glm::vec3(8, 4, 0));
    EXPECT_EQ(material_with(Json::object()).emission, glm::vec3(1, 0.5f, 0));
}

TEST(GltfExtensions, reflectance_comes_from_index_and_tint) {
    EXPECT_EQ(material_with(Json::object()).reflectance, 0.04f);
    // ((1.5 - 1) / (1.5 + 1))^2, ((2 - 1) / (2 + 1))^2; float's rounding
    EXPECT_NEAR(material_with({{"KHR_materials_ior", Json::object()}}).reflectance, 0.04, 1e-8);
    EXPECT_NEAR(material_with({{"KHR_materials_ior", {{"ior", 2}}}}).reflectance, 1 / 9.0, 1e-7);
    EXPECT_EQ(material_with({{"KHR_materials_ior", {{"ior", 0}}}}).reflectance, Material::largest_reflectance);
    Json const specular = {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}};
    Material const tinted = material_with({{"KHR_materials_specular", specular}});
    EXPECT_NEAR(tinted.reflectance, 0.02, 1e-8);
    EXPECT_EQ(tinted.specular, 0.5f);
}

TEST(GltfExtensions, unlit_is_a_switch) {
    EXPECT_TRUE(material_with({{"KHR_materials_unlit", Json::object()}}).unlit);
    EXPECT_FALSE(material_with(Json::object()).unlit);
}

TEST(GltfExtensions, textures_are_scaled_then_turned_then_moved) {
    Texture const texture =
        texture_with({{"offset", {0.25, 0.5}}, {"rotation", 1.5707963267948966}, {"scale", {2, 3}}, {"texCoord", 1}});
    EXPECT_EQ(texture.uv_set, 1) << "the extension's set goes before the reference's own";
    // (1, 1) -> (2, 3) -> counter-clockwise with v down: (3, -2) -> (3.25, -1.5); float's rounding
    glm::vec2 const uv = texture.uv_from_vertex * glm::vec3(1, 1, 1);
    EXPECT_NEAR(uv.x, 3.25, 1e-6);
    EXPECT_NEAR(uv.y, -1.5, 1e-6);
    EXPECT_EQ(texture_with(Json::object()).uv_from_vertex, glm::mat3x2(1));
}

TEST(GltfExtensions, numbers_are_checked) {
    auto const error = [](Json const& extensions) { return error_of(with_material({{"extensions", extensions}}).gltf()); };
    EXPECT_EQ(error({{"KHR_materials_ior", {{"ior", 0.5}}}}),
              "/materials/0/extensions/KHR_materials_ior/ior: must be 0, or 1 and above");
    EXPECT_EQ(error({{"KHR_materials_specular", {{"specularFactor", 2}}}}),
              "/materials/0/extensions/KHR_materials_specular/specularFactor: is above 1");
    EXPECT_EQ(error({{"KHR_materials_emissive_strength", {{"emissiveStrength", "much"}}}}),
              "/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength: must be a number");
    EXPECT_EQ(error({{"KHR_materials_unlit", 7}}), "/materials/0/extensions/KHR_materials_unlit: must be an object");
}

TEST(GltfExtensions, unknown_ones_are_refused_where_required_and_named_where_used) {
    GltfBuilder builder = one_triangle();
    builder.json["extensionsUsed"] = {"KHR_texture_basisu", "KHR_materials_unlit"};
    TemporaryFolder const folder;
    write_text_file(folder.path() / "a.gltf", builder.gltf());
    GltfSummary summary;
    load_gltf(folder.path() / "a.gltf", {}, &summary);
    EXPECT_EQ(summary.warnings.back().message, "loaded without KHR_texture_basisu, which is not supported");
    builder.json["extensionsRequired"] = {"KHR_texture_basisu"};
    EXPECT_NE(error_of(builder.gltf()).find("KHR_texture_basisu is required and not supported"), std::string::npos);
}

TEST(GltfExtensions, lights_are_read_and_left_out) {
    GltfBuilder builder = one_triangle();
    int const times = builder.add<float>("SCALAR", {0, 1});
    int const places = builder.add<float>("VEC3", {0, 0, 0, 1, 0, 0});
    builder.json["accessors"][times].update({{"min", {0}}, {"max", {1}}});
    builder.json["animations"] = {{{"samplers", {{{"input", times}, {"output", places}}}},
                                   {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "point"}, {"name", "lamp"}, {"intensity", 40}}, {{"type", "directional"}}});
    TemporaryFolder const folder;
    write_text_file(folder.path() / "a.gltf", builder.gltf());
    GltfSummary summary;
    load_gltf(folder.path() / "a.gltf", {}, &summary);
    EXPECT_EQ(summary.lights, (std::vector<std::string>{"point lamp of 40 cd", "directional light of 1 lx"}));
    EXPECT_EQ(summary.animations, 1u);
    EXPECT_EQ(warning_lines(summary).back(),
              "lights of the file (KHR_lights_punctual) are left out: the sun is the only light");
}
