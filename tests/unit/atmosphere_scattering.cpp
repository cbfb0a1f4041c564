#include "support/air.h"
#include "support/air_reference.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::shader;
namespace reference = alpenglow::test::reference;

namespace {
// Sunlight alone: nothing goes straight on.
Atmosphere sunlit_earth() {
    Atmosphere air = test::earth_air();
    for (shader::AirComponent& component : air.content.components) component.moments.degree[0] = 1;
    return air;
}
Atmosphere const AIR = sunlit_earth();

sampler2D no_light() {
    static test::Table const dark(1, LIGHT_TILES, [](vec2) { return vec4(0); });
    return dark.sampler();
}

// A view ray into the air, from its origin inside it.
struct View {
    AirRay ray;
    reference::Ray exact;
    float end;
};

// Rays of a picture: elevations around `pitch`, azimuths from the sun's [degrees], from altitude h [m], in space as
// well.
std::vector<View> picture(float h, double pitch, double sun_elevation, std::vector<double> const& azimuths) {
    std::vector<View> views;
    double const mu_s = std::sin(glm::radians(sun_elevation));
    for (double elevation = pitch - 16; elevation <= pitch + 30; elevation += 7.7)
        for (double const azimuth : azimuths) {
            double const mu = std::sin(glm::radians(elevation));
            double const nu =
                mu * mu_s + std::sqrt((1 - mu * mu) * (1 - mu_s * mu_s)) * std::cos(glm::radians(azimuth));
            float entry = 0;
            AirRay const ray =
                enter_air(AIR, make_air_ray(AIR.ground_radius, h, float(mu), float(mu_s), float(nu)), entry);
            float const end = air_segment(AIR, ray).end;
            if (end <= 0) continue;
            double const r0 = double(AIR.ground_radius) + ray.altitude;
            views.push_back({ray, {AIR.ground_radius, ray.altitude, ray.along / r0, ray.sun_along / r0, ray.nu}, end});
        }
    return views;
}

// Root mean square of the march's error over the picture, relative to the picture's own root mean square.
double march_error(std::vector<View> const& views, int n) {
    static reference::Air const exact(AIR);
    double wrong = 0, all = 0;
    for (View const& view : views) {
        AirLight const light =
            compute_air_light(AIR, test::earth_sunlight().sampler(), no_light(), view.ray, 0, view.end, n);
        dvec3 const truth = reference::single_scattering(exact, view.exact, 0, view.end);
        wrong += dot(dvec3(light.inscattered) - truth, dvec3(light.inscattered) - truth);
        all += dot(truth, truth);
    }
    return std::sqrt(wrong / all);
}
} // namespace

TEST(SegmentIntegral, meets_the_closed_form_thin_thick_and_empty) {
    for (double const extinction : {1e-12, 1e-7, 1e-5, 1.2e-4, 1e-3, 0.1}) {
        double const exact = 3 * -std::expm1(-extinction * 1000) / extinction;
        EXPECT_NEAR(integrate_segment(vec3(3), vec3(float(extinction)), 1000).y, exact, 1e-6 * exact) << extinction;
    }
    EXPECT_EQ(integrate_segment(vec3(3), vec3(0), 1000).x, 3000);
    EXPECT_EQ(integrate_segment(vec3(3), vec3(1), 0).x, 0);
}

// Sakmary's Eq. 4.5 blends with the transmittance where the opacity belongs.
TEST(SegmentIntegral, black_air_of_half_transmittance_halves_the_scene) {
    AirLight light = no_air_light();
    add_cell(light, vec3(0), vec3(std::log(2.0f) / 100), 100);
    EXPECT_FLOAT_EQ(behind_air(light, vec3(0.8f)).x, 0.4f);
}

TEST(SegmentIntegral, homogeneous_air_needs_no_more_than_one_cell) {
    AirLight one = no_air_light(), many = no_air_light();
    add_cell(one, vec3(2e-5f), vec3(3e-5f), 90000);
    for (int i = 0; i < 9; ++i) add_cell(many, vec3(2e-5f), vec3(3e-5f), 10000);
    EXPECT_NEAR(one.inscattered.x, many.inscattered.x, 1e-6);
    EXPECT_NEAR(one.transmittance.x, many.transmittance.x, 1e-6);
}

// Errors like those of the study behind the rule, where even or squared spacing is 3 to 39 % off with 14 to 30 samples.
// The table's own error, and the polynomial of the sun's disc, are in here.
TEST(March, single_scattering_meets_the_double_integral) {
    struct Case {
        float h;
        double pitch, sun, with_16, with_32;
    };
    for (Case const c :
         {Case{2, 10, 17, 0.02, 0.005}, Case{2, 10, 1, 0.02, 0.005}, Case{2, 10, -3, 0.02, 0.005},
          Case{10e3f, 0, 1, 0.006, 0.002}, Case{400e3f, -20, 17, 0.006, 0.002}, Case{400e3f, -20, -12, 0.05, 0.015}}) {
        auto const views = picture(c.h, c.pitch, c.sun, {25, 60, 110, 170});
        double const e16 = march_error(views, 16), e32 = march_error(views, 32);
        EXPECT_LT(e16, c.with_16) << c.h << " m, sun " << c.sun;
        EXPECT_LT(e32, c.with_32) << c.h << " m, sun " << c.sun;
    }
}

// Around the sun aerosol is nearly all there is, and its scale height is half of a cell of a steep ray.
TEST(March, the_aureole_meets_the_double_integral) {
    auto const views = picture(2, 10, 17, {3, 12});
    EXPECT_LT(march_error(views, 16), 0.06);
    EXPECT_LT(march_error(views, 32), 0.02);
    EXPECT_LT(march_error(views, 128), 0.002);
}

// A ray to distance d, plus its transmittance times what lies beyond, is the whole ray: no seam at the skyline.
TEST(March, a_ray_cut_in_two_is_the_whole_ray) {
    auto const march = [](AirRay const& ray, float begin, float end) {
        return compute_air_light(AIR, test::earth_sunlight().sampler(), no_light(), ray, begin, end, 32);
    };
    for (float const mu : {-0.01f, 0.0f, 0.05f, 0.5f})
        for (float const sun : {0.3f, 0.02f, -0.05f})
            for (float const share : {0.02f, 0.3f, 0.9f}) {
                AirRay const ray = make_air_ray(AIR.ground_radius, 2000, mu, sun, mu * sun + 0.4f);
                float const end = air_segment(AIR, ray).end;
                AirLight const whole = march(ray, 0, end), near = march(ray, 0, end * share),
                               far = march(ray, end * share, end);
                vec3 const joined = near.inscattered + near.transmittance * far.inscattered;
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(joined[c], whole.inscattered[c], 0.005f * whole.inscattered[c])
                        << mu << " " << sun << " " << share;
            }
}

TEST(March, without_air_there_is_no_light_and_no_loss) {
    Atmosphere const airless = test::no_air();
    test::Table const sunlight = test::make_sunlight_table(airless);
    AirRay const ray = make_air_ray(airless.ground_radius, 10, 0.1f, 0.2f, 0.3f);
    AirLight const light = compute_air_light(airless, sunlight.sampler(), no_light(), ray, 0, 5e5f, 8);
    EXPECT_EQ(light.inscattered, vec3(0));
    EXPECT_EQ(light.transmittance, vec3(1));
}
