#include "surface/brdf.glsl"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

using namespace alpenglow::shader;

namespace {

/// What GGX reflects of light from all round, in both parts of SpecularShare, over half vectors drawn as the distribution has them;
/// and the mean of the directions it comes from: x away from the viewer, y along the normal.
struct Reflected {
    double plain = 0, grazing = 0;
    glm::dvec2 plain_mean{0}, grazing_mean{0};
};

Reflected reflected(double roughness, double n_v) {
    constexpr int SIDE = 200;
    double const alpha = roughness * roughness, a2 = alpha * alpha, side = std::sqrt(1 - n_v * n_v);
    Reflected sum;
    for (int i = 0; i < SIDE; ++i) {
        double const u = (i + 0.5) / SIDE, n_h = std::sqrt((1 - u) / (1 + (a2 - 1) * u)), across = std::sqrt(1 - n_h * n_h);
        for (int j = 0; j < SIDE; ++j) {
            double const towards = across * std::cos(std::numbers::pi * (j + 0.5) / SIDE); // the viewer
            double const v_h = towards * side + n_h * n_v, n_l = 2 * v_h * n_h - n_v;
            if (v_h <= 0 || n_l <= 0) continue;
            double const visibility = 0.5 / (n_v * std::sqrt(n_l * n_l * (1 - a2) + a2) + n_l * std::sqrt(n_v * n_v * (1 - a2) + a2));
            double const weight = 4 * visibility * n_l * v_h / n_h / (SIDE * SIDE), grazing = weight * std::pow(1 - v_h, 5);
            glm::dvec2 const light(side - 2 * v_h * towards, n_l);
            sum.plain += weight - grazing, sum.grazing += grazing;
            sum.plain_mean += (weight - grazing) * light, sum.grazing_mean += grazing * light;
        }
    }
    sum.plain_mean /= sum.plain, sum.grazing_mean /= sum.grazing;
    return sum;
}

glm::dvec2 mean_of(Lobe const& lobe) { return glm::dvec2(lobe.middle.x, lobe.middle.y) * double(lobe.mean_length); }

} // namespace

// A fit: rough ground seen at a grazing angle reflects four times what it does from above.
TEST(SpecularShare, is_that_of_the_integral) {
    for (double const roughness : {0.3, 0.5, 0.7, 0.9, 1.0})
        for (double const n_v : {0.03, 0.1, 0.3, 0.6, 1.0}) {
            SpecularShare const share = specular_share(float(roughness * roughness), float(n_v));
            Reflected const exact = reflected(roughness, n_v);
            for (auto const& [f0, tolerance] : {std::pair(0.04, 0.025), std::pair(1.0, 0.06)})
                EXPECT_NEAR(f0 * double(share.plain) + double(share.grazing), f0 * exact.plain + exact.grazing, tolerance) << roughness << ' ' << n_v;
        }
}

// Both together, each as much as it counts.
TEST(SpecularLobes, look_where_the_reflected_light_comes_from) {
    vec3 const n(0, 1, 0);
    for (double const roughness : {0.3, 0.5, 0.7, 0.9, 1.0})
        for (double const n_v : {0.03, 0.1, 0.3, 0.6, 0.8}) {
            vec3 const v(-float(std::sqrt(1 - n_v * n_v)), float(n_v), 0);
            SpecularLobes const lobes = specular_lobes(float(roughness * roughness), n, v);
            Reflected const exact = reflected(roughness, n_v);
            EXPECT_NEAR(glm::length(lobes.plain.middle), 1, 1e-5);
            EXPECT_NEAR(glm::length(lobes.grazing.middle), 1, 1e-5);
            for (auto const& [f0, tolerance] : {std::pair(0.04, 0.05), std::pair(1.0, 0.1)}) {
                double const plain = f0 * exact.plain, all = plain + exact.grazing;
                glm::dvec2 const wrong = (plain * (mean_of(lobes.plain) - exact.plain_mean) + exact.grazing * (mean_of(lobes.grazing) - exact.grazing_mean)) / all;
                EXPECT_LT(glm::length(wrong), tolerance) << roughness << ' ' << n_v << ' ' << f0;
            }
        }
}

TEST(SpecularLobes, of_a_mirror_look_along_its_ray) {
    vec3 const n(0, 1, 0), v = glm::normalize(vec3(1, 1, 0));
    SpecularLobes const lobes = specular_lobes(make_surface(vec3(0), 1, 0).alpha, n, v);
    for (Lobe const& lobe : {lobes.plain, lobes.grazing}) {
        EXPECT_NEAR(glm::dot(lobe.middle, glm::normalize(vec3(-1, 1, 0))), 1, 1e-3);
        EXPECT_GT(lobe.mean_length, 0.98f);
    }
}

// Light all round of the radiance 1: a white metal gives back its share, and no light is made.
TEST(AmbientLight, is_reflected_whole_or_lost_to_the_facets) {
    Surface const metal = make_surface(vec3(1), 1, 0.5f), paint = make_surface(vec3(1), 0, 0.5f);
    SpecularShare const share = specular_share(metal.alpha, 0.7f);
    Mirrored const even{vec3(1), vec3(1)};
    EXPECT_NEAR(reflect_ambient(metal, 0.7f, vec3(PI), even).x, share.plain + share.grazing, 1e-6);
    EXPECT_NEAR(reflect_ambient(paint, 0.7f, vec3(PI), even).x, 1, 1e-6);
    EXPECT_LT(reflect_ambient(metal, 0.7f, vec3(PI), {vec3(0), vec3(1)}).x, 0.1);
    EXPECT_GT(reflect_ambient(metal, 0.05f, vec3(PI), {vec3(0), vec3(1)}).x, 0.1);
}
