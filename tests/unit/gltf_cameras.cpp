#include "core/error.h"
#include "scene/view.h"
#include "support/gltf_builder.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <numbers>

using namespace alpenglow;
using namespace alpenglow::test;
using Json = nlohmann::json;

namespace {

constexpr double RADIUS = 6.36e6;

/// A camera 5 m up and 10 m south of the scene's origin that looks east and 30 degrees down, and an orthographic one.
GltfBuilder with_cameras() {
    GltfBuilder builder = one_triangle();
    builder.json["cameras"] = {{{"name", "porch"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
                               {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0}}}}};
    // -Z is turned to +X by -90 degrees around +Y, after -30 degrees around +X.
    glm::dquat const turn = glm::angleAxis(-std::numbers::pi / 2, glm::dvec3(0, 1, 0)) *
                            glm::angleAxis(-std::numbers::pi / 6, glm::dvec3(1, 0, 0));
    builder.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 5, 10}}, {"rotation", {turn.x, turn.y, turn.z, turn.w}}});
    builder.json["nodes"].push_back({{"camera", 1}});
    builder.json["scenes"][0]["nodes"] = {0, 1, 2};
    return builder;
}

View view_of(std::string const& camera) {
    View view;
    view.name = "test";
    view.scene = "scene.gltf";
    view.placement = Placement{.anchor = {.latitude = 0.8, .longitude = 0.1, .altitude = 1000}};
    view.scene_camera = camera;
    return view;
}

} // namespace

TEST(GltfCameras, perspective_ones_are_listed) {
    Scene const scene = with_cameras().load();
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "porch");
    EXPECT_EQ(scene.cameras[0].vertical_fov, 0.7);
    EXPECT_EQ(glm::dvec3(scene.cameras[0].scene_from_camera[3]), glm::dvec3(0, 5, 10));
}

TEST(GltfCameras, stand_where_the_scene_stands) {
    View const view = with_scene_camera(view_of("porch"), with_cameras().load().cameras, RADIUS);
    EXPECT_TRUE(view.scene_camera.empty());
    EXPECT_NEAR(view.camera.heading, std::numbers::pi / 2, 1e-5) << "east, turned by 10 m of latitude";
    EXPECT_NEAR(view.camera.pitch, -std::numbers::pi / 6, 1e-5);
    EXPECT_NEAR(view.camera.roll, 0, 1e-5);
    EXPECT_EQ(view.camera.vertical_fov, 0.7);
    EXPECT_NEAR(view.camera.place.altitude, 1005, 1e-4) << "10 m away the plane is 8 micrometres above the sphere";
    EXPECT_NEAR((view.camera.place.latitude - 0.8) * RADIUS, -10, 0.01);
}

TEST(GltfCameras, bend_with_their_scene) {
    GltfBuilder builder = with_cameras();
    builder.json["nodes"][1]["translation"] = {0, 5, 100000};
    Scene scene = builder.load();
    curve_to_planet(scene, RADIUS, 1);
    View const view = with_scene_camera(view_of("porch"), scene.cameras, RADIUS);
    EXPECT_NEAR((view.camera.place.latitude - 0.8) * RADIUS, -100000, 20) << "anchor at 1000 m: 16 m in 100 km";
    EXPECT_NEAR(view.camera.place.altitude, 1005, 1);
    EXPECT_NEAR(view.camera.pitch, -std::numbers::pi / 6, 1e-3);
}

TEST(GltfCameras, names_that_do_not_exist_are_refused) {
    std::vector<SceneCamera> const cameras = with_cameras().load().cameras;
    try {
        with_scene_camera(view_of("attic"), cameras, RADIUS);
        FAIL();
    } catch (Error const& error) {
        EXPECT_STREQ(error.what(), "view test: the scene has no camera \"attic\" (it has porch)");
    }
}

TEST(GltfCameras, views_name_them_and_scenes) {
    TemporaryFolder const folder;
    auto const file = folder.path() / "a.json";
    write_text_file(file, R"({"scene": {"file": "b.gltf", "index": 2}, "camera": {"gltf": "porch"}})");
    View const view = load_view(file);
    EXPECT_EQ(view.scene_camera, "porch");
    EXPECT_EQ(view.scene_index, 2);
    EXPECT_FALSE(view.placement.has_value());
    write_text_file(file, view_text(view));
    View const again = load_view(file);
    EXPECT_EQ(again.scene_camera, "porch");
    EXPECT_EQ(again.scene_index, 2);
    write_text_file(file, R"({"scene": {"file": "b.gltf", "index": 1.5}, "camera": {"gltf": "porch"}})");
    EXPECT_THROW(load_view(file), Error);
    write_text_file(file, R"({"camera": {"gltf": "porch", "pitch": 3}})");
    EXPECT_THROW(load_view(file), Error);
}

TEST(GltfScenes, one_is_chosen_by_its_number) {
    GltfBuilder builder = one_triangle();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {7, 0, 0}}});
    builder.json["scenes"].push_back({{"name", "other"}, {"nodes", {1}}});
    EXPECT_EQ(builder.load().bounds.lowest.x, 0);
    EXPECT_EQ(builder.load({.scene_index = 1}).bounds.lowest.x, 7);
    builder.json["scene"] = 1;
    EXPECT_EQ(builder.load().bounds.lowest.x, 7);
    EXPECT_EQ(builder.load({.scene_index = 0}).bounds.lowest.x, 0);
    EXPECT_THROW(builder.load({.scene_index = 2}), Error);
}
