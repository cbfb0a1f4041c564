#include "support/gltf_builder.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

std::vector<float> const CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0};
std::vector<float> const UP = {0, 0, 1, 0, 0, 1, 0, 0, 1};

GltfBuilder with_targets(std::vector<double> const& weights) {
    GltfBuilder builder;
    int const positions = builder.add("VEC3", CORNERS), normals = builder.add("VEC3", UP);
    int const lifted = builder.add<float>("VEC3", {0, 0, 0, 0, 0, 2, 0, 0, 0});
    int const turned = builder.add<float>("VEC3", {4, 0, -1, 4, 0, -1, 4, 0, -1});
    builder.show({{"POSITION", positions}, {"NORMAL", normals}},
                 {{"targets", {{{"POSITION", lifted}}, {{"NORMAL", turned}}}}});
    if (!weights.empty()) builder.json["meshes"][0]["weights"] = weights;
    return builder;
}

/// A triangle on one joint (node 1) 10 m up, and its inverse bind matrix, which moves by (-1, 0, 0). The mesh's own
/// node stands elsewhere.
GltfBuilder with_skin(std::vector<std::uint8_t> const& joints, std::vector<float> const& weights) {
    GltfBuilder builder;
    int const positions = builder.add("VEC3", CORNERS), normals = builder.add("VEC3", UP);
    builder.show({{"POSITION", positions},
                  {"NORMAL", normals},
                  {"JOINTS_0", builder.add("VEC4", joints)},
                  {"WEIGHTS_0", builder.add("VEC4", weights)}});
    std::vector<float> const bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    int const view = builder.add_view(bind);
    int const matrices = builder.add_accessor(view, 5126, 1, "MAT4");
    // Turned by a quarter around +Y: +X goes to -Z.
    builder.json["nodes"].push_back({{"translation", {0, 10, 0}}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}});
    builder.json["nodes"][0]["translation"] = {500, 0, 0};
    builder.json["nodes"][0]["skin"] = 0;
    builder.json["scenes"][0]["nodes"].push_back(1);
    builder.json["skins"] = Json::array({{{"joints", {1}}, {"inverseBindMatrices", matrices}}});
    return builder;
}

glm::dvec3 place(Scene const& scene, std::size_t instance, std::size_t corner) {
    Instance const& shown = scene.instances[instance];
    Mesh const& mesh = scene.meshes[shown.mesh];
    return glm::dvec3(shown.scene_from_mesh * glm::dvec4(mesh.vertices[mesh.indices[corner]].position, 1));
}

void expect_near(glm::dvec3 const& a, glm::dvec3 const& b) {
    EXPECT_LT(glm::length(a - b), 1e-6) << a.x << ' ' << a.y << ' ' << a.z; // float's rounding
}

std::vector<float> const FULL = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
std::vector<std::uint8_t> const FIRST(12, 0);

} // namespace

TEST(GltfPose, targets_are_added_by_the_meshs_weights) {
    Scene const scene = with_targets({0.5, 0.25}).load();
    expect_near(place(scene, 0, 1), {1, 0, 1});
    expect_near(place(scene, 0, 2), {0, 1, 0});
    // (0, 0, 1) + 0.25 (4, 0, -1), made unit
    expect_near(scene.meshes[0].vertices[0].normal, {0.8, 0, 0.6});
    expect_near(place(with_targets({}).load(), 0, 1), {1, 0, 0});
}

TEST(GltfPose, a_nodes_weights_go_before_its_meshs) {
    GltfBuilder builder = with_targets({0.5, 0});
    builder.json["nodes"].push_back({{"mesh", 0}, {"weights", {2, 0}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    Scene const scene = builder.load();
    ASSERT_EQ(scene.meshes.size(), 2u);
    expect_near(place(scene, 0, 1), {1, 0, 1});
    expect_near(place(scene, 1, 1), {1, 0, 4});
}

TEST(GltfPose, joints_decide_where_a_skinned_mesh_stands) {
    Scene const scene = with_skin(FIRST, FULL).load();
    // (1, 0, 0) - (1, 0, 0) at the joint; (0, 1, 0) -> (-1, 1, 0) -> turned (0, 1, 1) -> up
    expect_near(place(scene, 0, 1), {0, 10, 0});
    expect_near(place(scene, 0, 2), {0, 11, 1});
    expect_near(scene.meshes[0].vertices[0].normal, {1, 0, 0});
    EXPECT_LT(glm::length(scene.bounds.lowest - glm::dvec3(0, 10, 0)), 1e-6);
}

TEST(GltfPose, weights_need_not_sum_to_one) {
    std::vector<float> half = FULL;
    for (float& weight : half) weight /= 2;
    expect_near(place(with_skin(FIRST, half).load(), 0, 2), {0, 11, 1});
}

TEST(GltfPose, joints_that_do_not_exist_are_refused) {
    std::vector<std::uint8_t> joints = FIRST;
    joints[4] = 3;
    EXPECT_EQ(error_of(with_skin(joints, FULL).gltf()),
              "/meshes/0/primitives/0/attributes/JOINTS_0: element 1 names joint 3, but there are 1");
    GltfBuilder fewer = with_skin(FIRST, FULL);
    fewer.json["skins"][0]["joints"] = {1, 0};
    EXPECT_NE(error_of(fewer.gltf()).find("/skins/0/inverseBindMatrices: has fewer elements than there are joints"), std::string::npos);
}
