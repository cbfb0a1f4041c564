#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{3, 3};
constexpr double HALF_LENGTH = 6000, HALF_HEIGHT = 600, HALF_WIDTH = 1; // of the wall [m]

/// The share of a disc of radius 1 that is above a straight edge which lies `height` below its centre.
double disc_share(double height) {
    double const h = std::clamp(height, -1.0, 1.0);
    return 0.5 + (h * std::sqrt(1 - h * h) + std::asin(h)) / glm::pi<double>();
}

/// Behind a long wall, with the sun over its edge. Rays run along the edge, so that each sees the same share of the sun all the way.
class SoftShafts : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        Scene scene = scene_of({matte(glm::vec3(0.1f))});
        add_box(scene, {0, HALF_HEIGHT, 0}, {HALF_LENGTH, HALF_HEIGHT, HALF_WIDTH});
        put(scene, stand_);
        settings_ = plain_settings();
        settings_.cascade_size = 4096;
        settings_.cascades = 1;
        settings_.shadow_reach = 8000;
        settings_.ceiling_size = 0;
        settings_.multiple_scattering = false;
        settings_.exact_steps = 200;
    }
    /// Light of a ray that starts `distance` [m] behind the edge and `height` above the sun's centre's light that passes it.
    double light(double distance, double height) {
        glm::dvec3 const across = glm::normalize(glm::cross(to_sun_, glm::dvec3(1, 0, 0))), up = across * glm::sign(across.y);
        double const edge = 2 * HALF_HEIGHT * up.y + HALF_WIDTH * std::abs(up.z);
        glm::dvec3 const eye = up * (edge + height) - distance * to_sun_ - glm::dvec3(0.5 * HALF_LENGTH, 0, 0);
        Camera const camera = stand_.camera(eye, eye + glm::dvec3(1, 0, 0), glm::radians(0.01));
        return pixel(radiance(stand_.view(camera, to_sun_), settings_, EXTENT), 1, 1).g;
    }
    /// The share of the sun that such rays see, for heights in the penumbra's radii.
    std::vector<double> shares(double distance, std::vector<double> const& heights) {
        double const radius = distance * std::tan(stand_.planet.sun_angular_radius);
        double const dark = light(distance, -2 * radius), lit = light(distance, 2 * radius);
        EXPECT_GT(lit, 1.5 * dark); // the air behind the wall's end is lit
        std::vector<double> result;
        for (double const height : heights) result.push_back((light(distance, height * radius) - dark) / (lit - dark));
        return result;
    }
    glm::dvec3 const to_sun_ = sun_at(8, 0);
    Stand const stand_ = stand_on(load_planet("misty"));
    Settings settings_;
};

} // namespace

// The cascade's texels are a fourth to an eighth of the penumbra's radius here.
TEST_F(SoftShafts, fade_over_the_width_of_the_suns_disc_behind_their_caster) {
    std::vector<double> const heights{-1.2, -0.6, -0.3, 0.0, 0.3, 0.6, 1.2};
    settings_.soft_shafts = true;
    for (char const* const level : {"default", "exact"}) {
        settings_.shafts = level;
        for (double const distance : {3000.0, 6000.0}) {
            std::vector<double> const found = shares(distance, heights);
            for (std::size_t i = 0; i < heights.size(); ++i)
                EXPECT_NEAR(found[i], disc_share(heights[i]), 0.1) << level << ", " << distance << " m, " << heights[i] << " radii";
        }
    }
}

TEST_F(SoftShafts, have_an_edge_without_the_setting) {
    std::vector<double> const found = shares(6000, {-0.3, 0.3});
    EXPECT_LT(found[0], 0.15); // of the disc it would be 0.31
    EXPECT_GT(found[1], 0.85);
}
