#include "support/render_test.h"

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{64, 36};

class FinitePixels : public RenderTest, public ::testing::WithParamInterface<char const*> {
protected:
    /// Draws every altitude under every sun, and expects each pixel to be a number and not below zero.
    void expect_all_finite(Stand const& stand) {
        Settings settings = plain_settings();
        settings.samples = 6;
        settings.cascade_size = settings.ceiling_size = 256;
        settings.sun_disc = settings.stars = true;
        std::vector<std::string> lights = choices_of(*find_setting("model"));
        lights.emplace_back("no air");
        for (std::string const& light : lights) {
            settings.air = light != "no air";
            settings.model = settings.air ? light : Settings{}.model;
            // The other models are opponents: a few places of each kind do.
            bool const few = settings.air && settings.model != Settings{}.model;
            std::vector<double> const altitudes = few ? std::vector{2.0, 12e3, 4e5} : std::vector{2.0, 900.0, 12e3, 1e5, 4e5, 2e7};
            std::vector<double> const suns = few ? std::vector{-6.0, 0.0, 45.0}
                                                 : std::vector{-18.0, -6.0, -0.27, 0.0, 0.27, 5.0, 45.0, 90.0};
            for (double const altitude : altitudes) {
                for (double const sun : suns) {
                    // Down to the horizon and beyond it, from anywhere.
                    double const dip = std::acos(stand.planet.radius / (stand.planet.radius + altitude));
                    glm::dvec3 const eye(0, altitude, 0), ahead(0, -std::sin(dip), -std::cos(dip));
                    World const world = stand.view(stand.camera(eye, eye + ahead, glm::radians(70.0)), sun_at(sun, 10));
                    FloatImage const image = radiance(world, settings, EXTENT);
                    int bad = 0;
                    for (float const value : image.rgba) bad += !(std::isfinite(value) && value >= 0);
                    EXPECT_EQ(bad, 0) << "altitude " << altitude << ", sun at " << sun << ", " << light;
                }
            }
        }
    }
};

} // namespace

TEST_P(FinitePixels, of_the_planet_alone_and_of_a_small_scene) {
    Stand const stand = stand_on(load_planet(GetParam()));
    expect_all_finite(stand);

    Scene scene = scene_of({matte({0.3f, 0.25f, 0.2f}), matte(glm::vec3(0))});
    scene.materials[1].metallic = 1;
    scene.materials[1].roughness = 0;
    add_plane(scene, 2000, 1);
    add_box(scene, {-6, 4, -12}, {3, 3, 3}, 1);
    add_ridge(scene, {-1000, 1, -900}, {1000, 1, -900}, 300, 400);
    put(scene, stand);
    expect_all_finite(stand);
}

INSTANTIATE_TEST_SUITE_P(Planets, FinitePixels, ::testing::Values("earth", "earth_hazy", "dense", "airless"),
                         [](auto const& given) { return std::string(given.param); });
