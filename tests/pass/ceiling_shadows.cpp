#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{192, 108};

/// Shadows beyond the cascades in whole pictures, without air, so that they are black.
class CeilingShadows : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        settings_ = plain_settings();
        settings_.cascade_size = 1024;
        settings_.shafts = "off";
    }
    glm::dvec3 in_scene(glm::dvec3 const& world) const { return glm::dvec3(glm::inverse(stand_.world_from_scene()) * glm::dvec4(world, 1)); }

    Stand stand_ = stand_on(airless_planet());
    Settings settings_;
};

} // namespace

// The ground is the planet's own, 60 km behind a ridge of 3 km whose mesh ends after 20; cascades reach 5 km. A sun ray over the crest
// meets the sphere where geometry says. The bound is the penumbra, 60 km of half a degree: 280 m along a ray, and 5 km on the ground.
TEST_F(CeilingShadows, of_a_ridge_fall_on_the_ground_sixty_kilometres_behind_it) {
    Scene scene = scene_of({matte(glm::vec3(0.5))});
    add_ridge(scene, {-20000, -200, 0}, {20000, -200, 0}, 4000, 3200);
    put(scene, stand_);
    settings_.shadow_reach = 5000;
    constexpr double ELEVATION = 3.1; // [degrees]
    glm::dvec3 const to_sun = sun_at(ELEVATION, 0), crest(0, 3000, 0);
    Camera const camera = stand_.camera({0, 30000, 60000}, {0, 0, 60000}, glm::radians(60.0), {0, 0, -1});
    std::vector<double> const seen = visibility(stand_.view(camera, to_sun), settings_, EXTENT);
    double const radius = stand_.planet.radius, rim = stand_.planet.sun_angular_radius;
    int dark = 0, lit = 0, wrong = 0;
    for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
        glm::dvec3 const along = pixel_direction(camera, EXTENT, i % EXTENT.width, i / EXTENT.width);
        double const b = glm::dot(camera.position, along), c = glm::dot(camera.position, camera.position) - radius * radius;
        glm::dvec3 const place = in_scene(camera.position + along * (-b - std::sqrt(b * b - c)));
        if (std::abs(place.x) > 19000) continue;
        double const angle = std::atan2(crest.y - place.y, place.z) - glm::radians(ELEVATION); // of the crest above the sun
        dark += angle > rim, lit += angle < -rim;
        // A texel of the map is 20 m, so the crest it knows is up to 8 m lower than the mesh's: 0.13 mrad from there.
        wrong += angle > rim + 2e-4 ? seen[i] > 0.01 : angle < -rim - 2e-4 && seen[i] < 0.99;
    }
    EXPECT_GT(dark, 2000);
    EXPECT_GT(lit, 2000);
    EXPECT_EQ(wrong, 0);

    settings_.ceiling_size = 0;
    std::vector<double> const without = visibility(stand_.view(camera, to_sun), settings_, EXTENT);
    // Without it half of that is lit: what doesn't lie behind the cascades, which know no end along a sun ray.
    EXPECT_LT(std::ranges::count_if(without, [](double v) { return v < 0.5; }), 0.5 * dark);
}

// The planet's ground 30 km beside a small ridge, the sun 0.6 degrees high: nothing hides it. Normals of 16 bits put 0.7 % on so low a sun.
TEST_F(CeilingShadows, leave_low_sunlight_on_the_planet_as_it_is_without_a_scene) {
    Scene scene = scene_of({matte(glm::vec3(0.5))});
    add_ridge(scene, {-200, -200, 0}, {200, -200, 0}, 400, 300);
    put(scene, stand_);
    Camera const camera = stand_.camera({30000, 2000, 0}, {30000, 0, 0}, glm::radians(60.0), {0, 0, -1});
    std::vector<double> const seen = visibility(stand_.view(camera, sun_at(0.6, 0)), settings_, EXTENT);
    EXPECT_GT(std::ranges::min(seen), 0.99);
    EXPECT_LT(std::ranges::max(seen), 1.01);
}

namespace {

constexpr double RIDGE_HEIGHT = 200, SUN_ELEVATION = 20; // [m, degrees]
double const EDGE = RIDGE_HEIGHT / std::tan(glm::radians(SUN_ELEVATION)); // of its shadow: this far behind it [m]
constexpr double REACH = 1500, AROUND = 60;                               // [m]

/// A step that is larger than both neighbours' twice; below `floor` none counts.
bool jumps(std::vector<double> const& places, double floor) {
    auto const step = [&](std::size_t i) { return std::abs(places[i + 1] - places[i]); };
    for (std::size_t i = 1; i + 2 < places.size(); ++i) {
        if (step(i) > floor && step(i) > 2 * std::max(step(i - 1), step(i + 1))) return true;
    }
    return false;
}

/// How far behind the ridge the shadow ends, from the mean of what is seen in strips around there.
double edge_seen(std::vector<double> const& visibility, auto const& place_of) {
    constexpr int STRIPS = 24;
    double sums[STRIPS]{}, counts[STRIPS]{};
    for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
        glm::dvec3 const place = place_of(i);
        double const strip = (place.z - EDGE + AROUND) / (2 * AROUND) * STRIPS;
        if (strip < 0 || strip >= STRIPS || std::abs(place.x) > AROUND) continue;
        sums[int(strip)] += visibility[i], ++counts[int(strip)];
    }
    double dark = 0;
    for (int i = 0; i < STRIPS; ++i) {
        EXPECT_GT(counts[i], 0) << i;
        dark += 1 - sums[i] / counts[i];
    }
    return EDGE - AROUND + 2 * AROUND * dark / STRIPS;
}

} // namespace

// The camera flies away from a place on a shadow's edge until the last cascade leaves it to the ceiling, in steps as wide as the blend
// between them.
TEST_F(CeilingShadows, take_over_from_the_last_cascade_without_a_step) {
    Scene scene = scene_of({matte(glm::vec3(0.5))});
    add_plane(scene, 3000);
    add_ridge(scene, {-2500, 0, 0}, {2500, 0, 0}, 100, RIDGE_HEIGHT);
    put(scene, stand_);
    settings_.shadow_reach = REACH;
    settings_.cascades = 1;
    settings_.cascade_size = 4096;
    std::vector<World> flight;
    std::vector<FloatImage> lit;
    Settings without = settings_;
    without.shadows = false;
    for (double away = 0.82 * REACH; away < 1.25 * REACH; away += 0.06 * REACH) {
        Camera const camera = stand_.camera({away, 600, EDGE}, {0, 0, EDGE}, std::atan(2.6 * AROUND / away));
        flight.push_back(stand_.view(camera, sun_at(SUN_ELEVATION, 0)));
        lit.push_back(radiance(flight.back(), without, EXTENT));
    }
    auto const edges = [&](Settings const& settings) {
        std::vector<double> result;
        for (std::size_t frame = 0; frame < flight.size(); ++frame) {
            Camera const& camera = flight[frame].camera;
            result.push_back(edge_seen(visibility(flight[frame], settings, lit[frame]), [&](std::uint32_t i) {
                glm::dvec3 const eye = in_scene(camera.position);
                glm::dvec3 const along = glm::transpose(glm::dmat3(stand_.world_from_scene())) *
                                         pixel_direction(camera, EXTENT, i % EXTENT.width, i / EXTENT.width);
                return eye - along * (eye.y / along.y);
            }));
        }
        return result;
    };
    // A cascade's receivers are moved out by two of its texels, which brings the edge nearer; the map's texels are 2.9 m.
    double const cascade_texel = 2 * REACH / settings_.cascade_size, bias = 2 * cascade_texel / std::tan(glm::radians(SUN_ELEVATION));
    std::vector<double> const places = edges(settings_);
    for (double const place : places) EXPECT_NEAR(place, EDGE, bias);
    EXPECT_FALSE(jumps(places, bias));

    for (int const size : {0, 64}) { // lit; flanks of one texel, whose crest is missed by up to half of one
        Settings wrong = settings_;
        wrong.ceiling_size = size;
        EXPECT_TRUE(jumps(edges(wrong), bias)) << size;
    }
}
