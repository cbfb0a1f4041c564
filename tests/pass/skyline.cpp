#include "render/frame_constants.h"
#include "support/light_reference.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{9, 9};   // the middle pixel's ray is the camera's axis
constexpr float GLOW = 1.0f;     // a radiance that the G-buffer holds exactly

/// Rays from a camera at `altitude` to the north, `elevation` degrees up, with and without a wall across them.
class SkylinePass : public RenderTest {
protected:
    void use(char const* planet, double altitude, double elevation) {
        stand_ = stand_on(load_planet(planet), altitude);
        ahead_ = sun_at(elevation, 0);
        settings_ = plain_settings();
        settings_.samples = 128;
        settings_.shadows = false;
        settings_.shafts = "off";
    }
    /// A wall across the ray that glows or not and reflects nothing: it turns away from the sun, which stands behind it.
    Scene wall(double distance, bool glows) const {
        Material material = black();
        material.emission = glm::vec3(glows ? GLOW : 0.0f);
        Scene scene = scene_of({material});
        glm::dvec3 const u(0.1 * distance, 0, 0);
        add_quad(scene, distance * ahead_, u, glm::cross(u, ahead_));
        return scene;
    }
    /// What the camera sees `along` metres ahead on its ray.
    glm::dvec3 seen(double along = 0) {
        glm::dvec3 const eye = along * ahead_;
        World const world = stand_.view(stand_.camera(eye, eye + ahead_, glm::radians(1.0), {0, 0.6, 0.8}), to_sun_);
        return pixel(radiance(world, settings_, EXTENT), EXTENT.width / 2, EXTENT.height / 2);
    }
    glm::dvec3 seen_with(Scene const& scene) {
        put(scene, stand_);
        glm::dvec3 const result = seen();
        renderer().set_scene(nullptr, {}, 1);
        return result;
    }
    double dip() const { return -glm::degrees(std::acos(stand_.planet.radius / (stand_.planet.radius + stand_.placement.anchor.altitude))); }

    Stand stand_;
    glm::dvec3 ahead_{0}, to_sun_ = sun_at(25, 40);
    Settings settings_;
};

/// The air as light from a surface meets it: a part of what is scattered goes straight on.
shader::Atmosphere straight_on_air(Planet const& planet) {
    shader::Atmosphere air = atmosphere_of(planet);
    for (shader::AirComponent& component : air.content.components)
        component.extinction -= (1 - component.moments.degree[0]) * component.scattering;
    return air;
}

double largest_relative(glm::dvec3 const& a, glm::dvec3 const& b) {
    glm::dvec3 const d = glm::abs(a - b) / b;
    return std::max({d.x, d.y, d.z});
}

} // namespace

TEST_F(SkylinePass, light_to_a_place_and_from_behind_it_make_up_the_skys) {
    for (double const altitude : {2.0, 300.0, 3e3, 12e3}) {
        use("earth", altitude, 0);
        for (double const elevation : {dip() + 0.02, 0.3, 3.0, 30.0}) {
            use("earth", altitude, elevation);
            glm::dvec3 const sky = seen();
            for (double const distance : {500.0, 8e3, 6e4}) {
                glm::dvec3 const near = seen_with(wall(distance, false));
                glm::dvec3 const transmittance = (seen_with(wall(distance, true)) - near) / static_cast<double>(GLOW);
                glm::dvec3 const whole = near + transmittance * seen(distance);
                EXPECT_LT(largest_relative(whole, sky), 0.005) << "from " << altitude << " m, " << elevation << " degrees up, cut at " << distance << " m";
            }
        }
    }
}

TEST_F(SkylinePass, a_segments_transmittance_is_that_of_the_integral) {
    // Near and far, level and steep.
    for (char const* const planet : {"earth", "earth_hazy", "dense"}) {
        for (double const altitude : {2.0, 3e3, 4e4}) {
            for (double const elevation : {0.05, 5.0, 60.0}) {
                use(planet, altitude, elevation);
                reference::Air const air(straight_on_air(stand_.planet));
                for (double const distance : {500.0, 8e3, 4e4}) {
                    glm::dvec3 const near = seen_with(wall(distance, false));
                    glm::dvec3 const transmittance = (seen_with(wall(distance, true)) - near) / static_cast<double>(GLOW);
                    reference::Ray const ray{air.radius(), altitude, std::sin(glm::radians(elevation))};
                    glm::dvec3 const expected = glm::exp(-reference::optical_depth(air, ray, 0, distance));
                    for (int c = 0; c < 3; ++c) {
                        if (expected[c] < 1e-3) continue; // lost beside the in-scattered light's own rounding
                        EXPECT_NEAR(transmittance[c] / expected[c], 1, 0.005) << planet << ' ' << altitude << ' ' << elevation << ' ' << distance;
                    }
                }
            }
        }
    }
}
