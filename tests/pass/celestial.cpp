#include "atmosphere/stars.glsl"
#include "atmosphere/sun_disc.glsl"
#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{160, 90};

double grey(glm::vec3 const& c) { return 0.2126 * double(c.x) + 0.7152 * double(c.y) + 0.0722 * double(c.z); }

/// A camera over the plain that looks `elevation` degrees up to the north.
class Celestial : public RenderTest {
protected:
    FloatImage look(char const* planet, double elevation, double sun_elevation, double fov, Settings const& settings) {
        Stand const stand = stand_on(load_planet(planet), 100);
        glm::dvec3 const eye(0, 2, 0), ahead = sun_at(elevation, 0);
        camera_ = stand.camera(eye, eye + ahead, glm::radians(fov));
        return radiance(stand.view(camera_, sun_at(sun_elevation, 0)), settings, EXTENT);
    }
    /// What all pixels of a picture add up to, by solid angle.
    glm::dvec3 irradiance(FloatImage const& image) const {
        glm::dvec3 sum(0);
        double const step = 2 * std::tan(0.5 * camera_.vertical_fov) / EXTENT.height;
        for (std::uint32_t y = 0; y < EXTENT.height; ++y)
            for (std::uint32_t x = 0; x < EXTENT.width; ++x) {
                double const cosine = glm::dot(pixel_direction(camera_, EXTENT, x, y), camera_.forward());
                sum += glm::dvec3(pixel(image, x, y)) * (step * step * cosine * cosine * cosine);
            }
        return sum;
    }
    static Settings with(bool sun, bool stars) {
        Settings settings = plain_settings();
        settings.samples = 16;
        settings.sun_disc = sun;
        settings.stars = stars;
        return settings;
    }
    Camera camera_;
};

glm::dvec3 difference(glm::dvec3 const& a, glm::dvec3 const& b) { return a - b; }

} // namespace

TEST_F(Celestial, the_discs_light_is_the_suns_irradiance) {
    for (double const fov : {60.0, 20.0, 2.0}) {
        for (int const aa : {1, 4}) {
            Settings settings = with(true, false);
            settings.aa = aa;
            glm::dvec3 const sum = irradiance(look("airless", 30, 30.1, fov, settings));
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1, 0.003) << fov << ' ' << aa;
        }
    }
}

TEST_F(Celestial, switches_take_sun_and_stars_away) {
    EXPECT_GT(irradiance(look("airless", 20, 20, 20, with(true, false))).y, 0.99);
    EXPECT_EQ(irradiance(look("airless", 20, 20, 20, with(false, false))).y, 0);
    EXPECT_GT(irradiance(look("airless", 30, -40, 60, with(false, true))).y, 1e-12);
    EXPECT_EQ(irradiance(look("airless", 30, -40, 60, with(false, false))).y, 0);
}

TEST_F(Celestial, the_ground_hides_the_sun) {
    EXPECT_EQ(irradiance(look("airless", -5, -5, 8, with(true, true))).y, 0);
}

TEST_F(Celestial, stars_stand_where_cpp_says) {
    Settings const settings = with(false, true);
    FloatImage const image = look("airless", 50, -40, 60, settings);
    Stand const stand = stand_on(load_planet("airless"), 100);
    glm::dvec3 const sun = glm::normalize(stand.world_direction(sun_at(-40, 0)));
    double const turn = std::atan2(sun.y, sun.x), c = std::cos(turn), s = std::sin(turn);
    auto const turned = [&](glm::dvec3 const& v) { return glm::vec3(c * v.x + s * v.y, c * v.y - s * v.x, v.z); };
    double const step = 2 * std::tan(0.5 * camera_.vertical_fov) / EXTENT.height;
    double sum = 0, off = 0;
    for (std::uint32_t y = 0; y < EXTENT.height; ++y)
        for (std::uint32_t x = 0; x < EXTENT.width; ++x) {
            glm::dvec3 const axis = camera_.forward(), ray = pixel_direction(camera_, EXTENT, x, y);
            shader::ViewPixel const view{turned(axis), turned(ray / glm::dot(ray, axis)),
                                         turned(step * camera_.world_from_camera[0]), turned(-step * camera_.world_from_camera[1])};
            double const expected = grey(shader::star_radiance(view, true));
            sum += expected;
            off += std::abs(grey(pixel(image, x, y)) - expected);
        }
    EXPECT_GT(sum, 0);
    EXPECT_LT(off, 0.01 * sum); // a pixel is 1e-2 rad and float directions 1e-7: 1e-4 of a tent on average
}

TEST_F(Celestial, the_air_colours_the_disc_as_it_colours_sunlight) {
    for (double const elevation : {40.0, 5.0, 0.6}) {
        Settings settings = with(true, false);
        glm::dvec3 const with_disc = irradiance(look("earth", elevation, elevation, 3, settings));
        settings.sun_disc = false;
        glm::dvec3 const direct = difference(with_disc, irradiance(look("earth", elevation, elevation, 3, settings)));
        EXPECT_GT(direct.x, direct.y);
        EXPECT_GT(direct.y, direct.z);
        // What a surface across the rays has of the sun, by another road: white, in shadow of nothing.
        Stand const stand = stand_on(load_planet("earth"), 100);
        settings.shadows = settings.multiple_scattering = false;
        settings.shafts = "off";
        Scene scene = scene_of({matte(glm::vec3(1))});
        glm::dvec3 const to_sun = sun_at(elevation, 0), u = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_sun));
        add_quad(scene, {0, 5, 0}, u, glm::cross(to_sun, u));
        put(scene, stand);
        glm::dvec3 const eye = glm::dvec3(0, 5, 0) + 3.0 * to_sun;
        World const world = stand.view(stand.camera(eye, {0, 5, 0}, 0.1), to_sun);
        glm::dvec3 const lit = glm::dvec3(pixel(radiance(world, settings, {9, 9}), 4, 4)) * 3.14159265;
        renderer().set_scene(nullptr, {}, 1);
        // The sky's light on the surface is in `lit` as well; near the horizon it hardly reddens.
        for (int c = 0; c < 3; ++c) EXPECT_GT(lit[c], 0.9 * direct[c]) << elevation;
        EXPECT_LT(direct.z / direct.x, lit.z / lit.x + 0.01) << elevation;
    }
}

TEST_F(Celestial, day_drowns_the_stars_and_night_does_not) {
    auto const share = [&](double sun_elevation) { // of a picture's brightest star, in what is seen there
        FloatImage const with_stars = look("earth", 60, sun_elevation, 60, with(false, true));
        FloatImage const without = look("earth", 60, sun_elevation, 60, with(false, false));
        double largest = 0;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
            double const a = with_stars.rgba[4 * i + 1], b = without.rgba[4 * i + 1];
            largest = std::max(largest, (a - b) / std::max(a, 1e-30));
        }
        return largest;
    };
    EXPECT_LT(share(30), 0.002); // half a step of 255
    EXPECT_LT(share(0), 0.004);
    EXPECT_GT(share(-18), 0.5);
}
