#include "atmosphere/shadow_ceiling.glsl"
#include "reference/terrain_mesh.h"
#include "support/mountains.h"
#include "support/render_test.h"

#include "gpu/transfer.h"
#include "render/executor.h"

#include <test_shaders.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr int SIZE = 512;      // texels of up to 66 m; the default terrain has 50 to 66 at 2048
constexpr int POINTS = 10000;
constexpr double TALLEST = 15e3; // [m]

struct Sun {
    double elevation, azimuth; // [degrees]
    int dark;                  // points at least: where the sun is high hardly any is
};
constexpr Sun SUNS[] = {{0.5, 33, 500}, {3, 117, 300}, {10, 201, 50}, {40, 290, 1}, {85, 63, 0}};

/// A place in the air, from the scene's origin in world axes.
struct AirPlace {
    glm::dvec3 world{0};
    bool dark = false;
};

struct Agreement {
    int dark = 0, wrong = 0, unexplained = 0;
};

/// The map of a scene of ridges, and rays through its triangles.
class ShadowCeilingMap : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        put(scene_, stand_);
        settings_.ceiling_size = SIZE;
        settings_.cascade_size = 256;
    }
    /// Draws with that sun and takes the map back.
    void make_map(Sun const& sun) {
        to_sun_ = glm::normalize(stand_.world_direction(sun_at(sun.elevation, sun.azimuth)));
        World const world{stand_.planet, stand_.camera({0, 5000, 9000}, {0, 0, 0}, 1), to_sun_};
        renderer().draw(world, settings_, {16, 9});
        texels_.clear();
        for (glm::vec2 const& texel : values_of<glm::vec2>(renderer().image_bytes("shadow_ceiling"))) texels_.emplace_back(texel, 0, 1);
        GpuScene const& gpu = *renderer().scene();
        fit_ = fit_ceiling({gpu.bounds(), gpu.world_from_scene()}, gpu.highest_altitude(), stand_.planet, to_sun_, SIZE);
        light_ = light_from_world(to_sun_, glm::dmat3(stand_.world_from_scene()));
        constants_ = ceiling_constants(fit_, light_, world.camera.position);
        camera_ = world.camera.position;
    }
    glm::vec3 light_of(glm::dvec3 const& world) const { return glm::vec3(light_ * (world - camera_)); }
    double visibility(shader::ShadowCeiling const& ceiling, glm::dvec3 const& world) const {
        return shader::ceiling_visibility({SIZE, SIZE, texels_.data()}, ceiling, shader::ceiling_place(ceiling, light_of(world)));
    }
    /// Above the ground; one in three stands behind the scene in its shadow's direction, up to 60 km away.
    std::vector<AirPlace> air_points() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<AirPlace> points;
        glm::dvec3 const away = -glm::normalize(fit_.axes[2]), up = fit_.axes[1];
        while (points.size() < POINTS) {
            glm::dvec3 place = stand_.world({24e3 * (unit(random) - 0.5), 0, 24e3 * (unit(random) - 0.5)});
            if (unit(random) < 1.0 / 3) place += away * 60e3 * unit(random);
            auto const ground = mesh_.first_hit(place + 2e4 * up, -up, 1e5, Sides::both);
            double const foot = ground ? glm::dot(ground->position - fit_.origin, up) + 1 : 0;
            double const height = foot + (TALLEST - foot) * unit(random);
            place += up * (height - glm::dot(place - fit_.origin, up));
            points.push_back({place, mesh_.occludes(place, to_sun_)});
        }
        return points;
    }
    /// Whether a ray to another place of the sun's disc, or one from within a texel across, falls otherwise.
    bool near_the_edge(AirPlace const& point) const {
        double const texel = constants_.texel, rim = stand_.planet.sun_angular_radius;
        glm::dvec3 const across = fit_.axes[0], over = glm::cross(across, to_sun_);
        for (int i = 0; i < 16; ++i) {
            double const angle = i * glm::pi<double>() / 8;
            glm::dvec3 const side = std::cos(angle) * across + std::sin(angle) * over;
            for (double const share : {0.33, 0.67, 1.0}) {
                if (mesh_.occludes(point.world, glm::normalize(to_sun_ + share * rim * side)) != point.dark) return true;
                if (mesh_.occludes(point.world + share * texel * side, to_sun_) != point.dark) return true;
            }
        }
        return false;
    }
    Agreement agreement(shader::ShadowCeiling const& ceiling, std::vector<AirPlace> const& points) const {
        Agreement result;
        for (AirPlace const& point : points) {
            result.dark += point.dark;
            if ((visibility(ceiling, point.world) < 0.5) == point.dark) continue;
            ++result.wrong;
            result.unexplained += !near_the_edge(point);
        }
        return result;
    }

    Stand stand_ = stand_on(airless_planet(), 0);
    Scene scene_ = mountains(stand_.planet.radius);
    TerrainMesh mesh_{scene_, stand_.placement, stand_.planet.radius};
    Settings settings_ = plain_settings();
    std::vector<glm::vec4> texels_;
    CeilingFit fit_;
    shader::ShadowCeiling constants_{};
    glm::dmat3 light_{1};
    glm::dvec3 to_sun_{0}, camera_{0};
};

} // namespace

TEST_F(ShadowCeilingMap, agrees_with_rays_through_the_terrain) {
    for (Sun const& sun : SUNS) {
        make_map(sun);
        std::vector<AirPlace> const points = air_points();
        Agreement const right = agreement(constants_, points);
        EXPECT_GE(right.dark, sun.dark) << sun.elevation;
        EXPECT_LE(right.wrong, POINTS / 200) << sun.elevation;
        EXPECT_EQ(right.unexplained, 0) << sun.elevation;

        shader::ShadowCeiling moved = constants_;
        moved.offset.y += 2 * moved.texel_v;
        moved.offset.x += 2 * moved.texel_v;
        EXPECT_GT(agreement(moved, points).unexplained, 0) << "two texels, " << sun.elevation;
    }
}

// Places on the triangles that face the sun, with the two texels towards it that are passed over.
TEST_F(ShadowCeilingMap, shades_the_ground_and_not_itself) {
    for (double const elevation : {3, 10, 40}) {
        make_map({elevation, 117, 0});
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-11e3, 11e3);
        glm::dvec3 const up = fit_.axes[1];
        double places = 0, lit = 0, falsely_dark = 0, falsely_lit = 0;
        while (places < POINTS) {
            glm::dvec3 const above = stand_.world({unit(random), 0, unit(random)}) + 2e4 * up;
            GroundPoint const ground = *mesh_.first_hit(above, -up, 1e5, Sides::both);
            if (glm::dot(ground.facing, to_sun_) < 0.02) continue; // in its own shadow, whatever stands around
            shader::CeilingPlace const place = shader::ceiling_surface_place(constants_, light_of(ground.position));
            double const seen = shader::ceiling_visibility({SIZE, SIZE, texels_.data()}, constants_, place);
            bool const is_lit = !mesh_.occludes(ground.position, to_sun_);
            ++places, lit += is_lit;
            (is_lit ? falsely_dark : falsely_lit) += std::abs(seen - (is_lit ? 1 : 0));
        }
        // A shadow's edge is off by up to a texel of 66 m on slopes that are kilometres long.
        EXPECT_LT(falsely_dark, 0.01 * lit) << elevation;
        EXPECT_LT(falsely_lit, 0.01 * places) << elevation;
    }
}

// Filters differ in the last bits of their weights, 1/256 of a texel at worst; the penumbra spreads that over its width.
TEST_F(ShadowCeilingMap, gives_the_same_on_the_device) {
    make_map({2, 117, 0});
    std::vector<AirPlace> const points = air_points();
    constexpr Extent SHAPE{100, POINTS / 100};
    std::vector<glm::vec4> places;
    for (AirPlace const& point : points) places.emplace_back(light_of(point.world), 0);
    auto const input = make_float_image(device(), places, SHAPE), map = make_float_image(device(), texels_, {SIZE, SIZE});
    auto const output = make_float_image(device(), places, SHAPE);
    FrameGraph graph;
    graph.add(ComputePass{"look", shaders::shadow_ceiling_look_comp,
                          {sampled(0, graph.import(*input, "places", ShowScale::unit, true), NEAREST_CLAMP),
                           stored(1, graph.import(*output, "result", ShowScale::unit, false)),
                           sampled(2, graph.import(*map, "map", ShowScale::unit, true))},
                          SHAPE, bytes_of(constants_)});
    Executor executor(device());
    executor.submit(graph);
    executor.wait();
    auto const seen = values_of<glm::vec4>(read_back(device(), *output));
    int differ = 0, partly = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double const expected = visibility(constants_, points[i].world);
        partly += expected > 0.01 && expected < 0.99;
        differ += std::abs(seen[i].x - expected) > 0.02;
    }
    EXPECT_GT(partly, 10);
    EXPECT_LE(differ, 2); // where a corner of the map is empty, a weight that one of them rounds to 0 decides
}

// The map is made when the sun or the scene changes, and not with the camera.
TEST_F(ShadowCeilingMap, is_made_when_the_sun_moves_and_kept_while_it_stands) {
    auto const made = [&](Sun const& sun) {
        make_map(sun);
        renderer().wait();
        return std::ranges::any_of(renderer().timings(), [](PassTime const& time) { return time.name == "shadow_ceiling"; });
    };
    EXPECT_TRUE(made({10, 201, 0}));
    EXPECT_FALSE(made({10, 201, 0}));
    EXPECT_TRUE(made({10.05, 201, 0}));
    put(scene_, stand_);
    EXPECT_TRUE(made({10.05, 201, 0}));
    settings_.ceiling_size = 0;
    EXPECT_FALSE(made({10.05, 201, 0}));
}
