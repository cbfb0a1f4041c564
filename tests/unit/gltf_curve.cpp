#include "core/error.h"
#include "scene/gltf.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace alpenglow;

namespace {

constexpr double radius = 6'360'000; // [m]

/// One triangle with its first vertex at `place` in the mesh, under `transform`.
Scene scene_with(glm::vec3 const& place, glm::dmat4 const& transform = glm::dmat4(1)) {
    Scene scene;
    Mesh mesh;
    mesh.vertices.resize(3);
    for (Vertex& vertex : mesh.vertices) vertex.tangent = {1, 0, 0, 1};
    mesh.vertices[0].position = place;
    mesh.vertices[1].position = place + glm::vec3(1, 0, 0);
    mesh.vertices[2].position = place + glm::vec3(0, 0, -1);
    mesh.indices = {0, 1, 2};
    mesh.parts = {{0, 3, 0, {}}};
    scene.meshes = {mesh};
    scene.materials.resize(1);
    scene.instances = {{0, transform}};
    return scene;
}

glm::dvec3 place_of(Scene const& scene, std::size_t instance = 0, std::size_t vertex = 0) {
    Instance const& placed = scene.instances[instance];
    return placed.scene_from_mesh * glm::dvec4(scene.meshes[placed.mesh].vertices[vertex].position, 1);
}

glm::dmat4 translation(double x, double y, double z) {
    glm::dmat4 matrix(1);
    matrix[3] = {x, y, z, 1};
    return matrix;
}

constexpr double millimetre = 1e-3;

} // namespace

TEST(GltfCurve, the_plane_drops_by_half_the_square_of_the_distance_over_the_radius) {
    Scene scene = scene_with({50'000, 0, 0});
    curve_to_planet(scene, radius, 1);
    EXPECT_NEAR(place_of(scene).y, -196.54, 0.01); // d²/2R; the next term, d⁴/24R³, is 1 mm
    EXPECT_NEAR(place_of(scene).y, -radius * (1 - std::cos(50'000 / radius)), 1e-4); // 1 - cos in double: 1e-9 m here
}

TEST(GltfCurve, distance_becomes_arc_length_and_height_altitude) {
    glm::dvec3 const flat(-60'000, 2'500, 80'000);
    Scene scene = scene_with(glm::vec3(flat));
    curve_to_planet(scene, radius, 1);
    glm::dvec3 const place = place_of(scene);
    double const angle = 100'000 / radius;
    EXPECT_NEAR(place.x, -0.6 * (radius + 2'500) * std::sin(angle), millimetre);
    EXPECT_NEAR(place.z, 0.8 * (radius + 2'500) * std::sin(angle), millimetre);
    EXPECT_NEAR(place.y, (radius + 2'500) * std::cos(angle) - radius, millimetre);
    EXPECT_NEAR(glm::length(place + glm::dvec3(0, radius, 0)), radius + 2'500, millimetre);
}

TEST(GltfCurve, the_scale_is_taken_into_account_and_left_to_the_placement) {
    Scene scene = scene_with({50, 2, 0}); // kilometres
    curve_to_planet(scene, radius, 1000);
    double const angle = 50'000 / radius;
    EXPECT_NEAR(place_of(scene).x * 1000, (radius + 2'000) * std::sin(angle), millimetre);
    EXPECT_NEAR(place_of(scene).y * 1000, (radius + 2'000) * std::cos(angle) - radius, millimetre);
}

TEST(GltfCurve, nothing_cancels_near_the_origin) {
    Scene scene = scene_with({1e-3f, 0.25f, 0});
    curve_to_planet(scene, radius, 1);
    EXPECT_NEAR(place_of(scene).x, 1e-3 * (1 + 0.25 / radius), 6e-8); // a float below 1 m
    EXPECT_NEAR(place_of(scene).y, 0.25, 6e-8);
    Scene centre = scene_with({0, 0, 0});
    curve_to_planet(centre, radius, 1);
    EXPECT_NEAR(glm::length(place_of(centre)), 0, 1e-7);
    EXPECT_EQ(centre.meshes[0].vertices[0].normal, glm::vec3(0, 1, 0));
}

TEST(GltfCurve, normals_and_tangents_are_units_and_turn_with_the_local_frame) {
    Scene scene = scene_with({0, 0, 0}, translation(2'000'000, 0, 0));
    curve_to_planet(scene, radius, 1);
    double const angle = 2'000'000 / radius;
    Vertex const& vertex = scene.meshes[0].vertices[0];
    EXPECT_NEAR(vertex.normal.x, std::sin(angle), 1e-6); // floats
    EXPECT_NEAR(vertex.normal.y, std::cos(angle), 1e-6);
    EXPECT_NEAR(vertex.tangent.x, std::cos(angle), 1e-6);
    EXPECT_NEAR(vertex.tangent.y, -std::sin(angle), 1e-6);
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
    EXPECT_EQ(vertex.tangent.w, 1);
    glm::dvec3 const from_centre = glm::normalize(place_of(scene) + glm::dvec3(0, radius, 0));
    EXPECT_NEAR(glm::dot(from_centre, glm::dvec3(vertex.normal)), 1, 1e-6);
}

TEST(GltfCurve, each_instance_gets_its_own_mesh_near_its_own_origin) {
    Scene scene = scene_with({0.123f, 0, 0}, translation(100'000, 0, 0));
    scene.instances.push_back({0, translation(0, 0, -100'000)});
    curve_to_planet(scene, radius, 1);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_NE(scene.instances[0].mesh, scene.instances[1].mesh);
    double const expected = radius * std::sin((100'000 + static_cast<double>(0.123f)) / radius);
    EXPECT_NEAR(place_of(scene, 0).x, expected, 1e-6); // a float at 100 km is 8 mm off
    EXPECT_NEAR(place_of(scene, 1).z, -radius * std::sin(100'000 / radius), 1e-3);
    for (Mesh const& mesh : scene.meshes) {
        for (Vertex const& vertex : mesh.vertices) EXPECT_LT(glm::length(vertex.position), 2);
        EXPECT_LE(mesh.parts[0].bounds.highest.x, 1);
    }
    EXPECT_NEAR(scene.bounds.lowest.y, -786, 1);
}

TEST(GltfCurve, mirrored_instances_keep_their_front) {
    glm::dmat4 mirror(1);
    mirror[0].x = -1;
    Scene scene = scene_with({0, 0, 0}, mirror);
    curve_to_planet(scene, radius, 1);
    Mesh const& mesh = scene.meshes[0];
    glm::vec3 const a = mesh.vertices[mesh.indices[0]].position, b = mesh.vertices[mesh.indices[1]].position,
                    c = mesh.vertices[mesh.indices[2]].position;
    EXPECT_GT(glm::cross(b - a, c - a).y, 0);
    EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(GltfCurve, a_scene_larger_than_the_planet_is_refused) {
    Scene scene = scene_with({50'000, 0, 0});
    EXPECT_THROW(curve_to_planet(scene, radius, 1000), Error);
}
