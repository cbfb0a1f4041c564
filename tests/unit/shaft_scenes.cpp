#include "terrain/shaft_scenes.h"

#include "scene/gltf.h"
#include "scene/view.h"
#include "support/files.h"
#include "terrain/block_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace alpenglow;

namespace {

Scene loaded(BlockMesh const& mesh) {
    test::TemporaryFolder const folder;
    std::filesystem::path const file = folder.path() / "mesh.glb";
    mesh.gltf("mesh", glm::vec3(0.5f)).write(file);
    return load_gltf(file, {});
}

/// What the triangles enclose where their fronts face out, by the divergence theorem.
double volume(Scene const& scene) {
    Mesh const& mesh = scene.meshes.at(0);
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        auto const corner = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.indices[i + k]].position); };
        sum += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6;
    }
    return sum;
}

} // namespace

TEST(ShaftScenes, committed_files_are_what_the_program_writes) {
    test::TemporaryFolder const folder;
    std::set<std::string> made;
    for (ShaftScene const& scene : shaft_scenes()) {
        std::string const name = std::string(scene.name) + ".glb";
        made.insert(name);
        scene.make().write(folder.path() / name);
        EXPECT_TRUE(read_file(folder.path() / name) == read_file(test::assets() / "scenes" / name))
            << name << " has changed: alpenglow scenes --out assets/scenes";
    }
    for (auto const& entry : std::filesystem::directory_iterator(test::assets() / "scenes"))
        EXPECT_TRUE(made.contains(entry.path().filename().string())) << entry.path();
}

TEST(ShaftScenes, views_and_flights_find_theirs) {
    std::set<std::string> used;
    for (auto const& entry : std::filesystem::directory_iterator(test::assets() / "views/shafts")) {
        View const view = load_view(entry.path());
        if (view.scene == "default") continue;
        EXPECT_TRUE(std::filesystem::exists(view.scene)) << view.scene;
        used.insert(std::filesystem::path(view.scene).stem());
    }
    for (ShaftScene const& scene : shaft_scenes()) EXPECT_TRUE(used.contains(std::string(scene.name))) << scene.name;
    EXPECT_TRUE(std::filesystem::exists(load_flight(test::assets() / "flights/through_a_shaft.json").base.scene));
}

/// All corners are whole numbers below 1000, so that sums in double are exact to far less than the tolerance.
TEST(BlockMesh, fronts_face_out) {
    BlockMesh slab;
    slab.add_slab({10, 20, 30}, {14, 25, 36});
    EXPECT_NEAR(volume(loaded(slab)), 4 * 5 * 6, 1e-9);

    BlockMesh box; // its missing floor lies in a plane through the origin and encloses nothing
    box.add_box({10, 0, 30}, {14, 5, 36});
    EXPECT_NEAR(volume(loaded(box)), 4 * 5 * 6, 1e-9);

    BlockMesh column;
    column.add_column(std::array<glm::vec2, 3>{{{3, 9}, {7, 9}, {5, 1}}}, 0, 10);
    EXPECT_NEAR(volume(loaded(column)), 4 * 8 / 2 * 10, 1e-9);
}

TEST(BlockMesh, sheets_face_up) {
    BlockMesh sheet;
    sheet.add_sheet(std::array<std::vector<glm::vec3>, 3>{{{{0, 2, 0}, {5, 2, 0}}, {{0, 2, -1}, {5, 2, -1}}, {{0, 2, -3}, {5, 2, -3}}}});
    Scene const scene = loaded(sheet);
    for (Vertex const& vertex : scene.meshes.at(0).vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
    EXPECT_NEAR(volume(scene), 5 * 3 * 2 / 3.0, 1e-6); // the pyramid below it, whose tip is the origin
}
