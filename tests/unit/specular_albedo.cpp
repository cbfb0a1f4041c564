#include "surface/brdf.glsl"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace alpenglow::shader;

namespace {

/// What GGX reflects of light from all round, over half vectors drawn as the distribution has them.
double reflected(double roughness, double n_v, double f0) {
    constexpr int SIDE = 200;
    double const alpha = roughness * roughness, a2 = alpha * alpha, side = std::sqrt(1 - n_v * n_v);
    double sum = 0;
    for (int i = 0; i < SIDE; ++i) {
        double const u = (i + 0.5) / SIDE, n_h = std::sqrt((1 - u) / (1 + (a2 - 1) * u)), across = std::sqrt(1 - n_h * n_h);
        for (int j = 0; j < SIDE; ++j) {
            double const v_h = across * std::cos(std::numbers::pi * (j + 0.5) / SIDE) * side + n_h * n_v;
            double const n_l = 2 * v_h * n_h - n_v;
            if (v_h <= 0 || n_l <= 0) continue;
            double const visibility = 0.5 / (n_v * std::sqrt(n_l * n_l * (1 - a2) + a2) + n_l * std::sqrt(n_v * n_v * (1 - a2) + a2));
            sum += (f0 + (1 - f0) * std::pow(1 - v_h, 5)) * 4 * visibility * n_l * v_h / n_h;
        }
    }
    return sum / (SIDE * SIDE);
}

} // namespace

TEST(SpecularAlbedo, is_that_of_the_integral) {
    // A fit: rough ground seen at a grazing angle reflects four times what it does from above.
    for (double const roughness : {0.3, 0.5, 0.7, 0.9, 1.0}) {
        for (double const n_v : {0.03, 0.1, 0.3, 0.6, 1.0}) {
            Surface const stone = make_surface(vec3(0), 0, float(roughness)), mirror = make_surface(vec3(1), 1, float(roughness));
            EXPECT_NEAR(specular_albedo(stone, float(n_v)).x, reflected(roughness, n_v, 0.04), 0.025) << roughness << ' ' << n_v;
            EXPECT_NEAR(specular_albedo(mirror, float(n_v)).x, reflected(roughness, n_v, 1), 0.06) << roughness << ' ' << n_v;
        }
    }
}

TEST(SpecularAlbedo, the_ambient_light_comes_from_where_the_lobe_looks) {
    Surface const smooth = make_surface(vec3(0), 1, 0.045f), rough = make_surface(vec3(0), 1, 1);
    vec3 const n(0, 1, 0), v = glm::normalize(vec3(1, 1, 0));
    EXPECT_NEAR(glm::dot(mirror_direction(smooth, n, v), glm::normalize(vec3(-1, 1, 0))), 1, 1e-4);
    EXPECT_NEAR(glm::dot(mirror_direction(rough, n, v), n), 1, 1e-6);
    // Light all round of the radiance 1: a white metal gives back its share, and no light is made.
    Surface const metal = make_surface(vec3(1), 1, 0.5f), paint = make_surface(vec3(1), 0, 0.5f);
    EXPECT_NEAR(reflect_ambient(metal, 0.7f, vec3(PI), vec3(1)).x, specular_albedo(metal, 0.7f).x, 1e-6);
    EXPECT_NEAR(reflect_ambient(paint, 0.7f, vec3(PI), vec3(1)).x, 1, 1e-6);
}
