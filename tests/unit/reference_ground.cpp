#include "reference/ground.h"

#include "support/scenes.h"

#include "reference/planet_body.h"
#include "reference/terrain_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace alpenglow {
namespace {

constexpr double PIXEL = 1e-3; // [rad]
constexpr double NO_END = std::numeric_limits<double>::infinity();

Placement const PLACE{{0.8, 0.13, 1500}};

/// Numbers and directions that are the same on every machine.
class Random {
public:
    double operator()(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    glm::dvec3 direction() {
        double const z = (*this)(-1, 1), a = (*this)(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }
    /// Unit, on n's side.
    glm::dvec3 above(glm::dvec3 const& n) {
        glm::dvec3 const d = direction();
        return glm::dot(d, n) < 0 ? -d : d;
    }

private:
    std::mt19937_64 bits_{7};
};

Planet uniform_planet() {
    Planet planet = make_earth();
    planet.look = GroundLook::uniform;
    planet.ground_albedo = {0.1, 0.2, 0.3};
    return planet;
}

/// World places and directions from the scene's.
struct Frame {
    glm::dmat4 world_from_scene;
    explicit Frame(Planet const& planet) : world_from_scene(alpenglow::world_from_scene(PLACE, planet.radius)) {}
    glm::dvec3 place(glm::dvec3 const& p) const { return glm::dvec3(world_from_scene * glm::dvec4(p, 1)); }
    glm::dvec3 along(glm::dvec3 const& d) const { return glm::normalize(glm::dmat3(world_from_scene) * d); }
    glm::dvec3 scene(glm::dvec3 const& world) const {
        glm::dmat3 const axes(world_from_scene);
        return glm::transpose(axes) * (world - glm::dvec3(world_from_scene[3]));
    }
};

/// In the precision of an x86's long double.
double distance_in_long_double(glm::dvec3 const& o, glm::dvec3 const& d, double radius) {
    long double b = 0, c = -static_cast<long double>(radius) * radius, a = 0;
    for (int i = 0; i < 3; ++i) {
        a += static_cast<long double>(d[i]) * d[i], b += static_cast<long double>(o[i]) * d[i];
        c += static_cast<long double>(o[i]) * o[i];
    }
    return static_cast<double>((-b - std::sqrt(b * b - a * c)) / a);
}

} // namespace

TEST(ReferenceGround, the_planets_surface_is_met_where_it_stands) {
    Planet const planet = uniform_planet();
    Ground const ground(planet, nullptr, {});
    Random random;
    for (double const altitude : {0.01, 2.0, 1e4, 4e5, 1e7}) {
        for (int i = 0; i < 300; ++i) {
            glm::dvec3 const origin = (planet.radius + altitude) * random.direction();
            glm::dvec3 const target = planet.radius * random.above(origin), direction = glm::normalize(target - origin);
            auto const hit = ground.first_hit(origin, direction);
            if (glm::dot(target, origin) < planet.radius * planet.radius) continue; // target is behind the horizon
            ASSERT_TRUE(hit);
            double const cosine = -glm::dot(hit->facing, direction);
            // Coordinates of 1e7 m are rounded by 1e-9; a flat ray meets the ground farther on by that over the cosine.
            EXPECT_NEAR(hit->distance, distance_in_long_double(origin, direction, planet.radius), 1e-8 / cosine);
            double const off = glm::length(hit->position) - planet.radius;
            EXPECT_GT(off, 0);
            EXPECT_LT(off, 1e-5);
            EXPECT_LT(glm::distance(hit->position, origin + hit->distance * direction), 1e-5);
            EXPECT_FALSE(ground.first_hit(origin, direction, hit->distance * (1 - 1e-9)));
        }
    }
}

TEST(ReferenceGround, a_place_on_the_planet_never_meets_itself_again) {
    Ground const ground(uniform_planet(), nullptr, {});
    Random random;
    for (int i = 0; i < 20'000; ++i) {
        glm::dvec3 const origin = 1.3e7 * random.direction();
        auto const hit = ground.first_hit(origin, glm::normalize(-origin + 6.3e6 * random(0, 1) * random.direction()));
        if (!hit) continue;
        glm::dvec3 const flat = glm::normalize(glm::cross(hit->facing, random.direction()));
        for (double const rise : {0.0, 1e-12, 1e-7, 1e-3}) {
            EXPECT_TRUE(ground.sees_out(hit->position, glm::normalize(flat + rise * hit->facing)));
        }
        EXPECT_FALSE(ground.sees_out(hit->position, glm::normalize(flat - 1e-3 * hit->facing)));
    }
}

TEST(ReferenceGround, who_stands_under_the_planets_surface_sees_up_only) {
    Planet const planet = uniform_planet();
    Ground const ground(planet, nullptr, {});
    glm::dvec3 const origin(0, 0, planet.radius - 30);
    EXPECT_TRUE(ground.sees_out(origin, {0, 0, 1}));
    auto const hit = ground.first_hit(origin, {0, 0, -1});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->distance, 0);
    EXPECT_NEAR(glm::length(hit->position), planet.radius, 1e-5);
}

TEST(ReferenceGround, cameras_see_the_look_and_later_light_the_mean_albedo) {
    Planet planet = make_earth();
    planet.ground_albedo = {0.1, 0.2, 0.3};
    Ground const ground(planet, nullptr, {});
    glm::dvec3 const origin(2e6, 3e6, 7e6), direction = glm::normalize(glm::dvec3(0.02, 0.1, 0) - origin);
    auto const seen = ground.first_hit(origin, direction, NO_END, PIXEL), met = ground.first_hit(origin, direction);
    ASSERT_TRUE(seen && met);
    double const footprint = PIXEL * seen->distance / std::sqrt(-glm::dot(seen->facing, direction));
    BodyLook const look = look_of_body(planet, origin + seen->distance * direction, footprint);
    EXPECT_EQ(seen->surface.gloss, 1);
    EXPECT_LT(glm::distance(seen->surface.diffuse, look.albedo), 1e-6);
    EXPECT_NE(look.albedo, planet.ground_albedo);
    EXPECT_EQ(met->surface.gloss, 0);
    EXPECT_EQ(met->surface.diffuse, planet.ground_albedo);

    planet.look = GroundLook::uniform;
    auto const plain = Ground(planet, nullptr, {}).first_hit(origin, direction, NO_END, PIXEL);
    EXPECT_EQ(plain->surface.gloss, 0); // as the renderer shades it
    EXPECT_EQ(plain->surface.diffuse, planet.ground_albedo);
}

/// Two patches 200 km apart: each stands 100 km from the middle of the scene.
class FarPatch : public testing::Test {
protected:
    static constexpr double EAST = 1e5, HALF = 700;

    FarPatch() : planet(uniform_planet()), frame(planet), scene(test::scene_of({test::matte(glm::vec3(0.5f))})) {
        // 10 km up: at 100 km the planet has fallen 800 m below the anchor's level plane anyway.
        for (double const side : {-1.0, 1.0}) {
            test::add_quad(scene, {side * EAST, 0, 0}, HALF * u, HALF * v);
        }
    }

    Planet planet;
    Frame frame;
    Scene scene;
    glm::dvec3 const u = glm::normalize(glm::dvec3(1, 0.2, 0.1));
    glm::dvec3 const n = glm::normalize(glm::cross(u, glm::dvec3(0.1, 0.1, -1)));
    glm::dvec3 const v = glm::cross(n, u);

    glm::dvec3 on_patch(double a, double b) const { return glm::dvec3(EAST, 0, 0) + a * HALF * u + b * HALF * v; }
};

TEST_F(FarPatch, is_met_within_the_stated_error) {
    Ground const ground(planet, &scene, PLACE);
    double const bound = TerrainMesh::position_error(EAST + HALF, 2 * HALF);
    EXPECT_LT(bound, 0.03);
    Random random;
    int met = 0;
    for (double const away : {3.0, 1e3, 1e5, 4e5, 2e7}) {
        for (int i = 0; i < 500; ++i) {
            glm::dvec3 const target = on_patch(random(-0.9, 0.9), random(-0.9, 0.9));
            glm::dvec3 const origin = frame.place(target + away * random.above(n));
            glm::dvec3 const direction = glm::normalize(frame.place(target) - origin);
            double const cosine = -glm::dot(direction, frame.along(n));
            if (cosine < 0.05) continue; // flat rays slide along by the error over the cosine
            auto const hit = ground.first_hit(origin, direction, NO_END, PIXEL);
            ASSERT_TRUE(hit);
            if (hit->surface.diffuse.r < 0.4) continue; // the planet stands between
            ++met;
            double const height = glm::dot(frame.scene(hit->position) - glm::dvec3(EAST, 0, 0), n);
            EXPECT_GT(height, 0) << away;
            EXPECT_LT(height, bound + 1e-4) << away; // the mesh's own corners are floats, good to 1e-4
            EXPECT_LT(glm::distance(hit->position, frame.place(target)), 2 * bound / cosine) << away;
            EXPECT_NEAR(hit->distance, glm::distance(origin, frame.place(target)), 2 * bound / cosine) << away;
        }
    }
    EXPECT_GT(met, 1500);
}

TEST_F(FarPatch, does_not_shade_itself_under_a_grazing_sun) {
    Ground const ground(planet, &scene, PLACE);
    glm::dvec3 const up = frame.along(n);
    Random random;
    for (int i = 0; i < 20'000; ++i) {
        glm::dvec3 const target = on_patch(random(-0.9, 0.9), random(-0.9, 0.9));
        auto const hit = ground.first_hit(frame.place(target + 500.0 * n), -up);
        ASSERT_TRUE(hit);
        ASSERT_LT(hit->distance, 501);
        glm::dvec3 const flat = glm::normalize(glm::cross(up, random.direction()));
        for (double const rise : {1e-6, 1e-3, 0.05}) {
            auto const again = ground.first_hit(hit->position, glm::normalize(flat + rise * up), 2 * HALF);
            EXPECT_FALSE(again) << "at " << rise << " after " << again->distance;
        }
        EXPECT_TRUE(ground.first_hit(hit->position, -up, 1.0));
    }
}

TEST(ReferenceTerrain, a_closed_shell_lets_nothing_out) {
    Planet const planet = uniform_planet();
    Frame const frame(planet);
    // A ball of many thin and slanting triangles with shared corners, 100 km from the scene's middle.
    constexpr int RINGS = 40, COLUMNS = 60;
    Scene scene = test::scene_of({test::matte(glm::vec3(0.5f))});
    Mesh mesh;
    for (int i = 0; i <= RINGS; ++i) {
        for (int j = 0; j < COLUMNS; ++j) {
            double const a = 3.141592653589793 * i / RINGS, b = 6.283185307179586 * j / COLUMNS,
                         r = 300 + 40 * std::sin(7 * a + 3 * b);
            double const across = i % RINGS == 0 ? 0 : std::sin(a); // all of a pole's corners are one place
            Vertex vertex;
            vertex.position =
                glm::vec3(r * across * std::cos(b), (i % RINGS == 0 ? 300 : r) * std::cos(a), r * across * std::sin(b));
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t i = 0; i < RINGS; ++i) {
        for (std::uint32_t j = 0; j < COLUMNS; ++j) {
            std::uint32_t const k = (j + 1) % COLUMNS, top = i * COLUMNS, low = top + COLUMNS;
            for (std::uint32_t const corner : {top + j, low + j, top + k, top + k, low + j, low + k})
                mesh.indices.push_back(corner);
        }
    }
    MeshPart part{0, static_cast<std::uint32_t>(mesh.indices.size()), 0, {}};
    part.bounds.include(glm::dvec3(-340)), part.bounds.include(glm::dvec3(340));
    mesh.parts.push_back(part);
    scene.meshes.push_back(mesh);
    glm::dvec3 const centre(1e5, 3000, 0);
    for (double const side : {-1.0, 1.0}) {
        scene.instances.push_back({0, glm::translate(glm::dmat4(1), glm::dvec3(side, 1, 1) * centre)});
    }
    Ground const ground(planet, &scene, PLACE);
    Random random;
    for (int i = 0; i < 100'000; ++i) {
        glm::dvec3 const start = centre + 100.0 * random(0, 1) * random.direction();
        // Straight at corners and edges, where a leak would be.
        std::size_t const at = 3 * static_cast<std::size_t>(random(0, RINGS * COLUMNS * 2));
        glm::dvec3 const a(mesh.vertices[mesh.indices[at]].position), b(mesh.vertices[mesh.indices[at + 1]].position);
        glm::dvec3 const target = centre + glm::mix(a, b, i % 3 ? random(0, 1) : 0.0);
        EXPECT_FALSE(ground.sees_out(frame.place(start), glm::normalize(frame.place(target) - frame.place(start))));
        EXPECT_TRUE(ground.first_hit(frame.place(start), random.direction(), 1000.0));
    }
}

TEST(ReferenceTerrain, backs_of_single_sided_triangles_stop_light_and_not_cameras) {
    Planet const planet = uniform_planet();
    Frame const frame(planet);
    Scene scene = test::scene_of({test::matte(glm::vec3(0.5f))});
    scene.materials[0].double_sided = false;
    test::add_plane(scene, 100, 500);
    for (bool const mirrored : {false, true}) {
        if (mirrored)
            scene.instances[0].scene_from_mesh = glm::scale(scene.instances[0].scene_from_mesh, glm::dvec3(-1, 1, 1));
        Ground const ground(planet, &scene, PLACE);
        glm::dvec3 const above = frame.place({5, 600, 7}), below = frame.place({5, 400, 7}),
                         up = frame.along({0, 1, 0});
        auto const front = ground.first_hit(above, -up, NO_END, PIXEL);
        ASSERT_TRUE(front);
        EXPECT_NEAR(front->distance, 100, 1e-3);
        EXPECT_GT(glm::dot(front->facing, up), 0.999);
        EXPECT_GT(glm::dot(front->shading, up), 0.999);
        EXPECT_FALSE(ground.first_hit(below, up, NO_END, PIXEL));
        auto const back = ground.first_hit(below, up);
        ASSERT_TRUE(back);
        EXPECT_LT(glm::dot(back->facing, up), -0.999);
        EXPECT_LT(glm::dot(back->shading, up), -0.999);
        EXPECT_FALSE(ground.sees_out(below, up));
        EXPECT_TRUE(ground.sees_out(above, up));
    }
}

TEST(ReferenceTerrain, the_nearer_of_planet_and_triangle_is_met) {
    Planet const planet = uniform_planet();
    Frame const frame(planet);
    Scene scene = test::scene_of({test::matte(glm::vec3(0.5f)), test::matte(glm::vec3(0.9f))});
    test::add_plane(scene, 100, -1600, 0); // 100 m under the planet's level
    test::add_plane(scene, 100, 20, 1);
    Ground const ground(planet, &scene, PLACE);
    glm::dvec3 const up = frame.along({0, 1, 0});
    auto const hit = ground.first_hit(frame.place({0, 50, 1}), -up);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 30, 1e-3);
    EXPECT_NEAR(ground.first_hit(frame.place({0, 0, 1}), -up)->distance, 1500, 1e-3);
    EXPECT_FALSE(ground.first_hit(frame.place({0, 50, 1}), -up, 29.9));
}

TEST(ReferenceTerrain, a_scene_without_triangles_is_no_scene) {
    Planet const planet = uniform_planet();
    Scene const scene = test::scene_of({});
    Ground const ground(planet, &scene, PLACE);
    EXPECT_TRUE(ground.sees_out({0, 0, planet.radius + 1}, {0, 0, 1}));
    EXPECT_TRUE(ground.first_hit({0, 0, planet.radius + 1}, {0, 0, -1}));
}

TEST(ReferenceTerrain, triangles_without_area_give_no_broken_numbers) {
    Planet const planet = uniform_planet();
    Frame const frame(planet);
    Scene scene = test::scene_of({test::matte(glm::vec3(0.5f))});
    test::add_triangles(
        scene, {0, 10, 0},
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {-5, 0, 0}, {0, 0, 0}, {5, 0, 0}, {-5, 0, 0}, {0, 1e-9, 0}, {5, 0, 0}});
    test::add_triangles(scene, {0, 10, 0}, {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}});
    scene.meshes[1].vertices[0].normal = glm::vec3(0);
    scene.meshes[1].vertices[1].normal = -scene.meshes[1].vertices[2].normal;
    scene.meshes[1].vertices[1].uv0 = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    Ground const ground(planet, &scene, PLACE);
    Random random;
    for (int i = 0; i < 20'000; ++i) {
        glm::dvec3 const target(random(-1, 1), 10, i % 2 ? random(-1e-3, 1e-3) : 0.0);
        glm::dvec3 const origin = frame.place(target + 5.0 * random.direction());
        auto const hit = ground.first_hit(origin, glm::normalize(frame.place(target) - origin));
        if (!hit) continue;
        double const sum = glm::dot(hit->position, glm::dvec3(1)) +
                           glm::dot(hit->facing + hit->shading, glm::dvec3(1)) + hit->distance;
        ASSERT_TRUE(std::isfinite(sum));
        ASSERT_NEAR(glm::length(hit->facing), 1, 1e-9);
        ASSERT_NEAR(glm::length(hit->shading), 1, 1e-9);
    }
}

} // namespace alpenglow
