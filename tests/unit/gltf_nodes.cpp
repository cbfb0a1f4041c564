#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

glm::dvec3 placed(Scene const& scene, std::size_t instance, glm::dvec3 const& point) {
    return scene.instances.at(instance).scene_from_mesh * glm::dvec4(point, 1);
}

void expect_near(glm::dvec3 const& a, glm::dvec3 const& b) {
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
    EXPECT_NEAR(a.z, b.z, 1e-12);
}

} // namespace

TEST(GltfNodes, scale_then_rotation_then_translation_through_the_hierarchy) {
    GltfBuilder builder = one_triangle();
    double const h = std::sqrt(0.5); // a quarter turn about +Y: +X goes to -Z
    builder.json["nodes"] = {{{"children", {1}}, {"translation", {100, 0, 0}}},
                             {{"mesh", 0}, {"scale", {2, 3, 4}}, {"rotation", {0, h, 0, h}}, {"translation", {0, 10, 0}}}};
    expect_near(placed(builder.load(), 0, {1, 0, 0}), {100, 10, -2});
    expect_near(placed(builder.load(), 0, {0, 1, 0}), {100, 13, 0});
}

TEST(GltfNodes, matrices_are_stored_by_columns_and_negative_scale_is_kept) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["matrix"] = {-1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1};
    Scene const scene = builder.load();
    expect_near(placed(scene, 0, {1, 1, 0}), {6, 10, 9});
    EXPECT_LT(glm::determinant(glm::dmat3(scene.instances[0].scene_from_mesh)), 0);
    EXPECT_EQ(scene.bounds.lowest, glm::dvec3(6, 8, 9));
    EXPECT_EQ(scene.bounds.highest, glm::dvec3(7, 10, 9));
}

TEST(GltfNodes, nodes_share_their_mesh) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {5, 0, 0}}}, {{"mesh", 0}, {"scale", {0, 0, 0}}}};
    builder.json["scenes"][0]["nodes"] = {0, 1, 2};
    Scene const scene = builder.load();
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.size(), 2u) << "a scale of zero hides a node";
    EXPECT_EQ(triangle_count(scene), 2u);
}

TEST(GltfNodes, the_default_scene_is_shown) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
    builder.json["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(placed(builder.load(), 0, {0, 0, 0}).x, 0);
    builder.json["scene"] = 1;
    EXPECT_EQ(placed(builder.load(), 0, {0, 0, 0}).x, 5);
}

TEST(GltfNodes, without_scenes_every_root_is_shown) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"mesh", 0}}};
    builder.json.erase("scenes");
    EXPECT_EQ(builder.load().instances.size(), 2u);
}

TEST(GltfNodes, cycles_several_parents_and_deep_chains_are_refused) {
    GltfBuilder builder = one_triangle();
    builder.json["scenes"][0]["nodes"] = {0};
    builder.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/1: is its own ancestor");
    builder.json["nodes"] = {{{"children", {1, 2}}}, {{"children", {2}}}, Json::object()};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/1/children/0: node 2 has a second parent");
    builder.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
    builder.json["scenes"][0]["nodes"] = {1};
    EXPECT_EQ(error_of(builder.gltf()), "/scenes/0/nodes/0: is a root of the scene, but has a parent");
    builder.json["scenes"][0]["nodes"] = {0, 0};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/0: stands twice in the scene");
    builder.json["nodes"] = Json::array();
    for (int i = 0; i < 501; ++i) {
        builder.json["nodes"].push_back(i < 500 ? Json{{"children", {i + 1}}} : Json::object());
    }
    builder.json["scenes"][0]["nodes"] = {0};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/500: stands 501 nodes deep, more than the limit of 500 (where the file is to be trusted, raise it with "
              "--set deepest_node=NUMBER)");
}

TEST(GltfNodes, what_is_no_placement_is_refused) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/0/rotation: is not a unit quaternion");
    builder.json["nodes"][0] = {{"mesh", 0}, {"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/0/matrix: must end in the row 0 0 0 1");
    builder.json["nodes"] = {{{"children", {1}}, {"scale", {1e30, 1e30, 1e30}}}, {{"mesh", 0}, {"scale", {1e30, 1, 1}}}};
    EXPECT_EQ(error_of(builder.gltf()), "/nodes/1: is placed out of a float's range");
}

TEST(GltfNodes, cameras_that_see_half_of_everything_are_left_out) {
    GltfBuilder builder = one_triangle();
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 0.1}}}}};
    builder.json["nodes"][0]["camera"] = 0;
    EXPECT_TRUE(builder.load().cameras.empty());
    builder.json["cameras"][0]["perspective"]["yfov"] = 3;
    EXPECT_EQ(builder.load().cameras.size(), 1u);
}
