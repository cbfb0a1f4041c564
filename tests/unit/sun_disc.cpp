#include "atmosphere/sun_disc.glsl"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace alpenglow::shader;

namespace {

constexpr float RADIUS = 0.004675f; // [rad]

/// A perspective view along -Z in double, and the pixels that the shader makes of it.
struct Camera {
    double fov; ///< [rad] vertical
    int width, height;

    double step() const { return 2 * std::tan(0.5 * fov) / height; }
    glm::dvec3 along(double x, double y) const {
        return {(x + 0.5 - 0.5 * width) * step(), -(y + 0.5 - 0.5 * height) * step(), -1};
    }
    DiscPixel pixel(int x, int y, glm::dvec3 const& sun, float radius) const {
        return disc_pixel(vec3(along(x, y)), vec3(step(), 0, 0), vec3(0, -step(), 0), vec3(sun), radius);
    }
    double solid_angle(int x, int y) const {
        double const d = glm::length(along(x, y));
        return step() * step() / (d * d * d);
    }
};

/// Irradiance across the direction to the sun that the picture's pixels add up to, for a unit of it from the disc.
glm::dvec3 irradiance(Camera const& camera, glm::dvec3 const& sun, float radius) {
    glm::dvec3 sum(0);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            DiscPixel const pixel = camera.pixel(x, y, sun, radius);
            vec3 const along(camera.along(x, y));
            if (!meets_disc(pixel, along, vec3(sun))) continue;
            double const cosine = glm::dot(glm::normalize(camera.along(x, y)), sun);
            sum += glm::dvec3(disc_share(pixel, 16)) * (double(sun_mean_radiance(radius)) * cosine * camera.solid_angle(x, y));
        }
    return sum;
}

glm::dvec3 limb(double mu) { return glm::dvec3(limb_darkening(float(mu))); }

} // namespace

// The table's own column for the mean over the disc, which its authors give beside the coefficients: 0.8360 and 0.8434
// around 680 nm, 0.8002 and 0.8061 around 550, 0.7495 and 0.7588 around 440.
TEST(SunDisc, the_mean_over_the_disc_is_one_and_the_sources) {
    glm::dvec3 sum(0);
    constexpr int N = 20000;
    for (int i = 0; i < N; ++i) sum += limb(std::sqrt(1 - (i + 0.5) / N)) / double(N); // even in area
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1, 1e-4) << c;
    glm::dvec3 const centre = limb(1);
    EXPECT_GT(1 / centre.x, 0.8360);
    EXPECT_LT(1 / centre.x, 0.8434);
    EXPECT_GT(1 / centre.y, 0.8002);
    EXPECT_LT(1 / centre.y, 0.8061);
    EXPECT_GT(1 / centre.z, 0.7495);
    EXPECT_LT(1 / centre.z, 0.7588);
}

TEST(SunDisc, the_limb_is_darker_and_redder) {
    for (double mu = 0; mu < 0.99; mu += 0.05)
        for (int c = 0; c < 3; ++c) EXPECT_LT(limb(mu)[c], limb(mu + 0.05)[c]) << mu;
    EXPECT_GT(limb(0.2).x / limb(1).x, 1.2 * (limb(0.2).z / limb(1).z));
}

TEST(SunDisc, its_irradiance_is_the_suns_at_any_size_and_place) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    struct Case { double degrees; int width, height; };
    // From a disc in one pixel to one that fills the picture; the last two are as wide as pictures get.
    for (Case const c : {Case{60, 96, 54}, {60, 320, 180}, {20, 96, 54}, {2, 96, 54}, {0.8, 96, 54}, {110, 256, 144}}) {
        Camera const camera{glm::radians(c.degrees), c.width, c.height};
        for (int i = 0; i < 6; ++i) {
            // Anywhere that is all inside the picture, out to the corners.
            double const inside = 0.5 - (1 + double(RADIUS) / camera.step()) / c.height;
            double const reach = std::max(inside, 0.0);
            double const x = (0.5 + reach * unit(random)) * c.width - 0.5, y = (0.5 + reach * unit(random)) * c.height - 0.5;
            glm::dvec3 const sun = glm::normalize(camera.along(x, y));
            glm::dvec3 const sum = irradiance(camera, sun, RADIUS);
            // 16 chords: 0.002; over a wide pixel, perspective bends what is taken as even.
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], 1, 0.002 + 0.1 * camera.step()) << c.degrees << " degrees, at " << x << ", " << y;
        }
    }
    Camera const wide{glm::radians(90.0), 128, 128};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(irradiance(wide, {0, 0, -1}, 0.3f)[k], 1, 0.002) << "a near star's planet";
}

TEST(SunDisc, a_pixel_is_the_mean_of_what_it_covers) {
    for (double const degrees : {60.0, 5.0, 1.0}) {
        Camera const camera{glm::radians(degrees), 33, 33};
        glm::dvec3 const sun = glm::normalize(camera.along(16.3, 15.8));
        double const sine = std::sin(double(RADIUS));
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 33; ++x) {
                DiscPixel const pixel = camera.pixel(x, y, sun, RADIUS);
                bool const meets = meets_disc(pixel, vec3(camera.along(x, y)), vec3(sun));
                glm::dvec3 exact(0);
                constexpr int N = 40;
                for (int i = 0; i < N * N; ++i) {
                    glm::dvec3 const ray =
                        glm::normalize(camera.along(x - 0.5 + (i % N + 0.5) / N, y - 0.5 + (i / N + 0.5) / N));
                    double const s = glm::length(glm::cross(ray, sun)) / sine;
                    if (s < 1) exact += limb(std::sqrt(1 - s * s)) / double(N * N);
                }
                if (!meets) EXPECT_EQ(exact.y, 0) << x << ' ' << y;
                // 1600 points of a pixel tell where its edge lies to 0.004 of a limb of 0.33; 0.003 for the chords.
                else EXPECT_NEAR(double(disc_share(pixel, 16).y), exact.y, 0.006) << degrees << ": " << x << ' ' << y;
            }
    }
}

TEST(SunDisc, there_is_no_second_one_opposite) {
    Camera const camera{glm::radians(20.0), 96, 54};
    EXPECT_EQ(irradiance(camera, {0, 0, 1}, RADIUS), glm::dvec3(0));
}

TEST(SunDisc, arc_sine_is_accurate) {
    for (double x = -1; x <= 1; x += 1.0 / 512) EXPECT_NEAR(double(arc_sine(float(x))), std::asin(x), 2.5e-7) << x;
}
