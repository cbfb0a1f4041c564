#include "reference/ground.h"
#include "reference/surface_material.h"

#include "support/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace alpenglow {
namespace {

/// A level triangle, seen from above: u to the east, v to the south. Picture 1 is its texture.
class Textured : public testing::Test {
protected:
    Textured() : scene(test::scene_of({})) {
        vertices[0].position = {0, 0, 0};
        vertices[1].position = {1, 0, 0};
        vertices[2].position = {0, 0, 1};
        texture.picture = 1;
        set_uv({0, 0});
    }

    /// All corners at one place of the picture.
    void set_uv(glm::vec2 uv) {
        for (Vertex& vertex : vertices) vertex.uv0 = uv;
    }
    void set_picture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba) {
        scene.pictures.resize(1);
        scene.pictures.push_back({"picture", width, height, std::move(rgba)});
    }
    TrianglePlace place(glm::dvec3 const& weights = {0.5, 0.25, 0.25}) const {
        return {{&vertices[0], &vertices[1], &vertices[2]}, weights};
    }
    double red(glm::vec2 uv, bool srgb = false) {
        set_uv(uv);
        return sample_texture(scene, texture, place(), srgb).r;
    }

    Scene scene;
    Texture texture;
    std::array<Vertex, 3> vertices;
};

double linear(double srgb_byte) { return std::pow((srgb_byte / 255 + 0.055) / 1.055, 2.4); }

glm::dvec3 const UP(0, 1, 0);
glm::dmat3 const NOT_TURNED(1);

} // namespace

TEST_F(Textured, coordinates_are_moved_into_the_picture) {
    set_picture(2, 1, {255, 0, 0, 255, 0, 0, 0, 255});
    texture.magnify = TextureFilter::nearest;
    EXPECT_EQ(red({0.25f, 0.5f}), 1);
    texture.uv_from_vertex = glm::mat3x2(1, 0, 0, 1, 0.5f, 0);
    EXPECT_EQ(red({0.25f, 0.5f}), 0);
    texture.uv_from_vertex = glm::mat3x2(0, 1, 1, 0, 0, 0); // u and v change places
    EXPECT_EQ(red({0.25f, 0.75f}), 0);
    EXPECT_EQ(red({0.75f, 0.25f}), 1);
}

TEST_F(Textured, dielectrics_reflect_as_their_material_says) {
    Material material;
    material.metallic = 0;
    material.reflectance = 0.1f, material.specular = 0.5f;
    GroundSurface const surface = surface_at(scene, material, place());
    EXPECT_NEAR(surface.specular.r, 0.1, 1e-8); // float's rounding
    EXPECT_EQ(surface.gloss, 0.5);
    material.metallic = 1;
    EXPECT_EQ(surface_at(scene, material, place()).gloss, 1) << "a metal has no dielectric part";
}

TEST_F(Textured, unlit_surfaces_shine_and_reflect_nothing) {
    Material material;
    material.base_color = {0.5f, 1, 0.25f, 1};
    material.unlit = true;
    GroundSurface const surface = surface_at(scene, material, place());
    EXPECT_EQ(surface.diffuse, glm::dvec3(0));
    EXPECT_EQ(surface.gloss, 0);
    EXPECT_NEAR(emission_at(scene, material, place()).r, 0.5 / M_PI, 1e-9);
}

TEST_F(Textured, texels_are_made_linear_before_they_are_mixed) {
    set_picture(2, 1, {255, 0, 0, 51, 188, 0, 0, 255});
    EXPECT_NEAR(red({0.5f, 0.5f}, true), 0.5 * (1 + linear(188)), 1e-9);
    EXPECT_NEAR(red({0.5f, 0.5f}, false), 0.5 * (1 + 188 / 255.0), 1e-9);
    EXPECT_NEAR(red({0.25f, 0.9f}, true), 1, 1e-9);
    EXPECT_NEAR(red({0.375f, 0.5f}, true), 0.75 + 0.25 * linear(188), 1e-9);
    EXPECT_NEAR(sample_texture(scene, texture, place(), true).a, 0.75 * 0.2 + 0.25, 1e-9); // alpha always is linear
}

TEST_F(Textured, sixteen_bits_are_read_as_such) {
    scene.pictures.resize(2);
    scene.pictures[1] = {"deep", 2, 1, {}, {0, 0, 0, 65535, 1, 40000, 40000, 32768}};
    texture.magnify = TextureFilter::nearest;
    EXPECT_EQ(red({0.75f, 0.5f}), 1 / 65535.0);
    EXPECT_EQ(red({0.75f, 0.5f}, true), 1 / 65535.0 / 12.92);
    glm::dvec4 const texel = sample_texture(scene, texture, place(), true);
    EXPECT_NEAR(texel.g, std::pow((40000 / 65535.0 + 0.055) / 1.055, 2.4), 1e-12);
    EXPECT_EQ(texel.a, 32768 / 65535.0);
}

TEST_F(Textured, dielectrics_reflect_as_textures_say) {
    set_picture(1, 1, {188, 255, 0, 51});
    Material material;
    material.metallic = 0;
    material.reflectance = 0.1f, material.specular = 0.5f;
    material.reflectance_shares = {0.5f, 0.25f, 0.25f};
    material.specular_texture = material.reflectance_texture = texture;
    GroundSurface const surface = surface_at(scene, material, place());
    EXPECT_NEAR(surface.specular.r, 0.1 * (0.5 * linear(188) + 0.25), 1e-8);
    EXPECT_NEAR(surface.gloss, 0.5 * 0.2, 1e-12);
    material.reflectance = 0.9f;
    EXPECT_EQ(surface_at(scene, material, place()).specular.r, Material::largest_reflectance);
}

TEST_F(Textured, pictures_wrap_at_their_edges) {
    set_picture(2, 1, {255, 0, 0, 255, 0, 0, 0, 255});
    EXPECT_NEAR(red({0.0f, 0.5f}), 0.5, 1e-6);
    EXPECT_NEAR(red({-0.75f, 0.5f}), 1, 1e-6);
    EXPECT_NEAR(red({7.25f, -3.0f}), 1, 1e-6);
    texture.wrap_u = TextureWrap::clamp;
    EXPECT_NEAR(red({-5.0f, 0.5f}), 1, 1e-6);
    EXPECT_NEAR(red({5.0f, 0.5f}), 0, 1e-6);
    texture.wrap_u = TextureWrap::mirror;
    EXPECT_NEAR(red({1.25f, 0.5f}), 0, 1e-6);
    EXPECT_NEAR(red({-0.25f, 0.5f}), 1, 1e-6);
    EXPECT_NEAR(red({0.0f, 0.5f}), 1, 1e-6);
    texture.magnify = TextureFilter::nearest;
    EXPECT_NEAR(red({0.45f, 0.5f}), 1, 1e-6);
    EXPECT_NEAR(red({0.55f, 0.5f}), 0, 1e-6);
}

TEST_F(Textured, coordinates_are_interpolated_in_the_set_that_is_asked_for) {
    set_picture(2, 1, {255, 0, 0, 255, 0, 0, 0, 255});
    vertices[0].uv1 = {0.25f, 0}, vertices[1].uv1 = {0.75f, 0}, vertices[2].uv1 = {0.25f, 0};
    texture.uv_set = 1;
    EXPECT_NEAR(sample_texture(scene, texture, place({0.2, 0.4, 0.4}), false).r, 0.6, 1e-6);
}

TEST_F(Textured, broken_coordinates_give_a_texel) {
    set_picture(1, 1, {51, 0, 0, 255});
    for (float const bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e30f}) {
        EXPECT_NEAR(red({bad, 0.5f}), 0.2, 1e-6);
        EXPECT_NEAR(red({0.5f, bad}), 0.2, 1e-6);
    }
}

TEST_F(Textured, a_surface_is_the_product_of_factors_textures_and_vertex_colours) {
    set_picture(1, 1, {188, 128, 51, 255});
    Material material;
    material.base_color = {0.5f, 1, 1, 1};
    material.metallic = 0.5f, material.roughness = 0.8f;
    material.base_color_texture = material.metallic_roughness_texture = texture;
    for (Vertex& vertex : vertices) vertex.color = {0.25f, 1, 1, 1};
    double const metalness = 0.5 * 0.2, roughness = 0.8f * 128 / 255.0, albedo = 0.125 * linear(188);
    auto const surface = surface_at(scene, material, place());
    EXPECT_NEAR(surface.diffuse.r, albedo * (1 - metalness), 1e-9);
    EXPECT_NEAR(surface.specular.r, 0.04 * (1 - metalness) + albedo * metalness, 1e-6);
    EXPECT_NEAR(surface.alpha, roughness * roughness, 1e-9);

    EXPECT_EQ(emission_at(scene, material, place()), glm::dvec3(0));
    material.emission = {2, 1, 1};
    material.emission_texture = texture;
    EXPECT_NEAR(emission_at(scene, material, place()).r, 2 * linear(188), 1e-9);
}

TEST_F(Textured, a_normal_map_leans_along_u_and_against_v) {
    vertices[0].uv0 = {0, 0}, vertices[1].uv0 = {1, 0}, vertices[2].uv0 = {0, 1};
    Material material;
    material.normal_texture = texture;
    set_picture(1, 1, {255, 128, 255, 255});
    glm::dvec3 const east = shading_normal(scene, material, place(), NOT_TURNED, UP);
    // 128 stands for 1/255.
    glm::dvec3 const expected_east = glm::normalize(glm::dvec3(1, 1, -1 / 255.0));
    EXPECT_LT(glm::distance(east, expected_east), 1e-9);
    set_picture(1, 1, {128, 255, 255, 255});
    glm::dvec3 const north = shading_normal(scene, material, place(), NOT_TURNED, UP);
    EXPECT_LT(glm::distance(north, glm::normalize(glm::dvec3(1 / 255.0, 1, -1))), 1e-9);
    material.normal_scale = 0;
    EXPECT_LT(glm::distance(shading_normal(scene, material, place(), NOT_TURNED, UP), UP), 1e-9);

    // The same picture laid mirrored: decreasing v still is up in it.
    material.normal_scale = 1;
    vertices[1].uv0 = {-1, 0};
    EXPECT_LT(glm::distance(shading_normal(scene, material, place(), NOT_TURNED, UP),
                            glm::normalize(glm::dvec3(-1 / 255.0, 1, -1))),
              1e-9);
}

TEST_F(Textured, given_tangents_lie_where_the_texture_would_put_them) {
    vertices[0].uv0 = {0, 0}, vertices[1].uv0 = {1, 0}, vertices[2].uv0 = {0, 1};
    Material material;
    material.normal_texture = texture;
    set_picture(1, 1, {200, 90, 230, 255});
    for (glm::dmat3 const& world_from_mesh :
         {NOT_TURNED, glm::dmat3(2.0), glm::dmat3{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}) {
        for (Vertex& vertex : vertices) vertex.tangent = glm::vec4(0);
        glm::dvec3 const derived = shading_normal(scene, material, place(), world_from_mesh, UP);
        for (Vertex& vertex : vertices) vertex.tangent = {1, 0, 0, 1};
        EXPECT_LT(glm::distance(shading_normal(scene, material, place(), world_from_mesh, UP), derived), 1e-9);
    }
}

TEST_F(Textured, normals_turn_to_the_side_they_are_seen_from_and_follow_scaling) {
    Material const material;
    EXPECT_EQ(shading_normal(scene, material, place(), NOT_TURNED, UP), UP);
    EXPECT_EQ(shading_normal(scene, material, place(), NOT_TURNED, -UP), -UP);
    glm::dmat3 mirrored(1);
    mirrored[0].x = -1;
    EXPECT_EQ(shading_normal(scene, material, place(), mirrored, UP), UP);
    for (Vertex& vertex : vertices) vertex.normal = glm::normalize(glm::vec3(1, 1, 0));
    glm::dmat3 high(1);
    high[1].y = 2; // a slope that is made steeper
    EXPECT_LT(glm::distance(shading_normal(scene, material, place(), high, UP), glm::normalize(glm::dvec3(2, 1, 0))),
              1e-7);
    for (Vertex& vertex : vertices) vertex.normal = glm::vec3(0);
    EXPECT_EQ(shading_normal(scene, material, place(), NOT_TURNED, UP), UP);
}

TEST(ReferenceMaterial, what_a_mask_cuts_out_lets_everything_through) {
    Planet const planet = make_earth();
    Placement const placement{{0.8, 0.13, 1500}};
    glm::dmat4 const world = world_from_scene(placement, planet.radius);
    Material leaf = test::matte(glm::vec3(0.5f));
    leaf.alpha_mask = true;
    leaf.base_color_texture.picture = 1;
    leaf.base_color_texture.magnify = TextureFilter::nearest;
    Scene scene = test::scene_of({leaf});
    scene.pictures.push_back({"holes", 2, 1, {255, 255, 255, 255, 255, 255, 255, 0}});
    test::add_plane(scene, 10, 100);
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv0 = {vertex.position.x / 20 + 0.5f, 0.5f};
    Ground const ground(planet, &scene, placement);
    glm::dvec3 const up = glm::normalize(glm::dvec3(world[1]));
    for (double const x : {-9.0, -1.0, -0.01, 0.01, 5.0}) {
        glm::dvec3 const below(world * glm::dvec4(x, 50, 0.3, 1));
        bool const hole = x > 0;
        EXPECT_EQ(ground.sees_out(below, up), hole) << x;
        EXPECT_EQ(ground.first_hit(below, up, 1e3).has_value(), !hole) << x;
        EXPECT_EQ(ground.first_hit(below, up, 1e3, 1e-3).has_value(), !hole) << x;
    }
}

} // namespace alpenglow
