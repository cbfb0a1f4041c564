#include "render/frame_constants.h"
#include "support/components.h"
#include "support/light_reference.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{16, 8};

/// Thick low haze, so that a few hundred metres of shadow are a large part of a ray's light.
Planet foggy_planet() {
    Planet planet;
    planet.look = GroundLook::uniform;
    planet.air.top_altitude = 5000;
    planet.sun_angular_radius = 0; // as in the integral; half a degree is 70 m wide eight kilometres behind an edge
    planet.air.components = {
        test::rayleigh_component(glm::dvec3(1e-5, 2e-5, 4e-5), 2000),
        test::aerosol_component(glm::dvec3(1.5e-3), glm::dvec3(1e-4, 1e-4, 2e-4), 300, 0.5)};
    return planet;
}

/// Maps of few texels: nothing here has much of a shape.
Settings small_maps() {
    Settings settings = plain_settings();
    settings.cascade_size = 512;
    settings.ceiling_size = 256;
    return settings;
}

Settings many_samples() {
    Settings settings = plain_settings();
    settings.samples = 512;
    settings.multiple_scattering = false; // a smooth light that shafts leave alone
    return settings;
}

class ShaftsPass : public RenderTest {
protected:
    reference::Air air() const { return reference::Air(atmosphere_of(stand_.planet)); }
    reference::LightPath path(World const& world, std::uint32_t x, std::uint32_t y) const {
        return {world.camera.position, pixel_direction(world.camera, EXTENT, x, y), 0, world.to_sun};
    }
    Stand stand_ = stand_on(foggy_planet(), 20);
};

double largest_relative(glm::dvec3 const& a, glm::dvec3 const& b) {
    glm::dvec3 const d = glm::abs(a - b) / b;
    return std::max({d.x, d.y, d.z});
}

/// A few pixels, all over the picture.
constexpr glm::uvec2 PIXELS[] = {{1, 1}, {5, 6}, {8, 4}, {12, 2}, {14, 7}};

} // namespace

TEST_F(ShaftsPass, two_occluders_on_one_ray_are_worth_what_the_integral_says) {
    // Rays go east to a black wall at 300 m that is turned away from the sun; between them and the sun, which stands in the
    // north and a little east, are two walls with a gap.
    constexpr double BACK = 300;
    Scene scene = scene_of({black()});
    add_quad(scene, {BACK, 0, 0}, {0, 0, 40}, {0, 40, 0});
    Scene alone = scene;
    for (double const middle : {80.0, 190.0}) add_quad(scene, {middle, 40, -30}, {25, 0, 0}, {0, 40, 0});
    Settings const settings = many_samples();
    glm::dvec3 const to_sun = sun_at(30, 20);
    World const world = stand_.view(stand_.camera({0, 5, 0}, {BACK, 5, 0}, glm::radians(4.0)), to_sun);
    put(scene, stand_);
    FloatImage const drawn = radiance(world, settings, EXTENT);

    reference::Occluders const occluders(scene, stand_), back(alone, stand_);
    for (glm::uvec2 const& at : PIXELS) {
        reference::LightPath path = this->path(world, at.x, at.y);
        path.length = BACK / glm::dot(path.direction, stand_.world_direction({1, 0, 0}));
        glm::dvec3 const expected = reference::sunlit_air(air(), &occluders, path), open = reference::sunlit_air(air(), &back, path);
        EXPECT_LT(expected.g, 0.8 * open.g); // the walls matter
        EXPECT_LT(largest_relative(pixel(drawn, at.x, at.y), expected), 0.01);
    }
}

TEST_F(ShaftsPass, casters_before_all_that_the_camera_sees_are_kept) {
    // Neither stands where a map that is fitted to the view begins: one hangs beside the camera, 8 m from its rays, the other eight
    // kilometres towards the sun. Without either of them the rays would be a tenth brighter at least.
    constexpr double BACK = 300;
    glm::dvec3 const to_sun = sun_at(30, 20), east(1, 0, 0), across = glm::normalize(glm::cross(to_sun, east)), eye(0, 5, 0);
    Scene scene = scene_of({black()});
    add_quad(scene, {BACK, 0, 0}, {0, 0, 40}, {0, 40, 0});
    Scene near = scene, far = scene;
    auto const add_near = [&](Scene& to) { add_quad(to, eye + 15.0 * east + 8.0 * to_sun, 25.0 * east, 5.0 * across); };
    auto const add_far = [&](Scene& to) { add_quad(to, eye + 150.0 * east + 8000.0 * to_sun, 60.0 * east, 60.0 * across); };
    add_near(scene), add_near(near), add_far(scene), add_far(far);
    World const world = stand_.view(stand_.camera(eye, {BACK, 5, 0}, glm::radians(4.0)), to_sun);
    put(scene, stand_);
    FloatImage const drawn = radiance(world, many_samples(), EXTENT);

    reference::Occluders const both(scene, stand_), without_far(near, stand_), without_near(far, stand_);
    for (glm::uvec2 const& at : PIXELS) {
        reference::LightPath path = this->path(world, at.x, at.y);
        path.length = BACK / glm::dot(path.direction, stand_.world_direction(east));
        glm::dvec3 const expected = reference::sunlit_air(air(), &both, path);
        for (reference::Occluders const* const dropped : {&without_far, &without_near})
            EXPECT_GT(reference::sunlit_air(air(), dropped, path).g, 1.1 * expected.g);
        // Of some 160 m in the light four edges are off by up to half a texel of 0.9 m each; and 0.6 % is left to interpolation.
        EXPECT_LT(largest_relative(pixel(drawn, at.x, at.y), expected), 0.02);
    }
}

TEST_F(ShaftsPass, a_ridge_takes_away_what_the_integral_says) {
    // In the shadow of a ridge 400 m to the north, looking over it towards the sun.
    Scene scene = scene_of({black()});
    add_ridge(scene, {-3000, 0, -400}, {3000, 0, -400}, 100, 200);
    put(scene, stand_);
    World const world = stand_.view(stand_.camera({0, 2, 0}, {0.05, 2 + std::tan(glm::radians(38.0)), -1}, glm::radians(8.0)), sun_at(20, 0));
    Settings settings = many_samples();
    FloatImage const on = radiance(world, settings, EXTENT);
    settings.shafts = "off";
    FloatImage const off = radiance(world, settings, EXTENT);

    reference::Occluders const ridge(scene, stand_);
    for (glm::uvec2 const& at : PIXELS) {
        reference::LightPath path = this->path(world, at.x, at.y);
        path.length = reference::to_top(air(), path.origin, path.direction);
        glm::dvec3 const lit = reference::sunlit_air(air(), nullptr, path), shaded = reference::sunlit_air(air(), &ridge, path);
        glm::dvec3 const seen_off = pixel(off, at.x, at.y), seen_on = pixel(on, at.x, at.y);
        EXPECT_LT(shaded.g, 0.9 * lit.g);
        EXPECT_LT(largest_relative(seen_off, lit), 0.005);
        EXPECT_LT(largest_relative(seen_on, shaded), 0.01);
        EXPECT_LT(largest_relative(seen_off - seen_on, lit - shaded), 0.03);
    }
}

TEST_F(ShaftsPass, make_no_difference_where_nothing_occludes) {
    // Rays over a plate 20 km wide, which shades nothing above it, under a clear sky at the default number of samples.
    for (char const* const name : {"earth_hazy", "earth"}) {
        stand_ = stand_on(load_planet(name), 0);
        Scene scene = scene_of({matte(glm::vec3(0.2f))});
        add_plane(scene, 1e4, 10);
        put(scene, stand_);
        for (double const elevation : {6.0, 40.0}) {
            for (double const height : {60.0, 2000.0}) {
                for (double const heading : {0.0, 120.0}) {
                    glm::dvec3 const ahead = sun_at(8, heading);
                    World const world = stand_.view(stand_.camera({0, height, 0}, glm::dvec3(0, height, 0) + ahead, glm::radians(40.0)), sun_at(elevation, 30));
                    Settings settings = small_maps();
                    settings.shadows = false;
                    FloatImage const on = radiance(world, settings, EXTENT);
                    settings.shafts = "off";
                    FloatImage const off = radiance(world, settings, EXTENT);
                    double worst = 0;
                    for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
                        worst = std::max(worst, largest_relative(pixel(on, i % EXTENT.width, i / EXTENT.width), pixel(off, i % EXTENT.width, i / EXTENT.width)));
                    }
                    EXPECT_LT(worst, 0.005) << name << ", sun at " << elevation << ", eye at " << height << ", heading " << heading;
                }
            }
        }
    }
}

TEST_F(ShaftsPass, of_a_small_scene_leave_no_edge_in_the_sky) {
    // Over plates from 2 m to 2 km wide, which shade nothing above them. Towards the sun a ray stays above the plate's square of
    // the cascades for long, beside it not at all; the eye sees an edge of half a percent.
    stand_ = stand_on(load_planet("earth"), 0);
    for (double const half_width : {1.0, 10.0, 100.0, 1000.0}) {
        Scene scene = scene_of({matte(glm::vec3(0.2f))});
        add_plane(scene, half_width, 10);
        put(scene, stand_);
        glm::dvec3 const eye(0, 10 + half_width, 0);
        World const world = stand_.view(stand_.camera(eye, eye + sun_at(25, 30), glm::radians(90.0)), sun_at(20, 30));
        Settings settings = small_maps();
        settings.shadows = false;
        FloatImage const on = radiance(world, settings, EXTENT);
        settings.shafts = "off";
        FloatImage const off = radiance(world, settings, EXTENT);
        double worst = 0;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
            worst = std::max(worst, largest_relative(pixel(on, i % EXTENT.width, i / EXTENT.width), pixel(off, i % EXTENT.width, i / EXTENT.width)));
        }
        EXPECT_LT(worst, 0.004) << half_width;
    }
}
