#include "reference/surface_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace alpenglow {
namespace {

constexpr double PI = std::numbers::pi;

GroundPoint flat(glm::dvec3 const& albedo, double metalness, double roughness) {
    GroundPoint point;
    point.facing = point.shading = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    point.surface = make_ground_surface(albedo, metalness, roughness);
    return point;
}

/// A direction at an angle [rad] from `n`.
glm::dvec3 tilted(glm::dvec3 const& n, double angle, double azimuth = 0.7) {
    glm::dvec3 const t = glm::normalize(glm::cross(n, glm::dvec3(0.1, 0.9, 0.2))), b = glm::cross(n, t);
    return std::cos(angle) * n + std::sin(angle) * (std::cos(azimuth) * t + std::sin(azimuth) * b);
}

/// Integral of reflect() over the sphere by the midpoint rule around the mirrored direction.
glm::dvec3 albedo_by_quadrature(GroundPoint const& point, glm::dvec3 const& viewer, int steps) {
    glm::dvec3 const mirror = glm::normalize(glm::reflect(-viewer, point.shading));
    glm::dvec3 sum(0);
    for (int i = 0; i < steps; ++i) {
        // The polar angle grows as the cube of the index: fine where a lobe is.
        double const x = (i + 0.5) / steps, angle = PI * x * x * x, width = 3 * PI * x * x / steps;
        for (int j = 0; j < steps; ++j) {
            glm::dvec3 const light = glm::normalize(tilted(mirror, angle, 2 * PI * (j + 0.5) / steps));
            sum += reflect(point, viewer, light) * std::sin(angle) * width * (2 * PI / steps);
        }
    }
    return sum;
}

struct Mean {
    glm::dvec3 value{0}, deviation{0}; ///< deviation: standard, of the mean
};

Mean albedo_by_samples(GroundPoint const& point, glm::dvec3 const& viewer, int count) {
    std::mt19937_64 bits(1);
    auto const random = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    glm::dvec3 sum(0), squares(0);
    for (int i = 0; i < count; ++i) {
        double const u1 = random(), u2 = random(), u3 = random();
        auto const sample = sample_reflection(point, viewer, u1, u2, u3);
        if (!sample) continue;
        EXPECT_TRUE(std::isfinite(sample->weight.g));
        EXPECT_NEAR(glm::length(sample->direction), 1, 1e-12);
        EXPECT_GT(glm::dot(sample->direction, point.facing), 0);
        sum += sample->weight;
        squares += sample->weight * sample->weight;
    }
    glm::dvec3 const mean = sum / double(count), variance = glm::max(squares / double(count) - mean * mean, 0.0);
    return {mean, glm::sqrt(variance / double(count))};
}

} // namespace

TEST(ReferenceScattering, weights_average_to_the_albedo_by_quadrature) {
    for (double const roughness : {0.1, 0.3, 0.6, 1.0}) {
        for (double const metalness : {0.0, 1.0}) {
            for (double const angle : {0.0, 0.6, 1.2, 1.5}) {
                GroundPoint const point = flat(glm::dvec3(0.5, 0.7, 0.9), metalness, roughness);
                glm::dvec3 const viewer = tilted(point.shading, angle);
                glm::dvec3 const expected = albedo_by_quadrature(point, viewer, 500);
                Mean const mean = albedo_by_samples(point, viewer, 100'000);
                // Of 96 normal numbers one is beyond four deviations with a chance of 0.6 %; the quadrature has 1e-5.
                for (int i = 0; i < 3; ++i) {
                    EXPECT_NEAR(mean.value[i], expected[i], 4 * mean.deviation[i] + 1e-5)
                        << "roughness " << roughness << " metalness " << metalness << " angle " << angle;
                }
            }
        }
    }
}

TEST(ReferenceScattering, a_white_metal_gives_back_no_more_than_it_gets) {
    for (double const roughness : {0.0, 0.1, 0.3, 0.6, 1.0}) {
        for (double const angle : {0.0, 0.6, 1.2, 1.5}) {
            GroundPoint const point = flat(glm::dvec3(1), 1, roughness);
            Mean const mean = albedo_by_samples(point, tilted(point.shading, angle), 20'000);
            EXPECT_LT(mean.value.g, 1 + 4 * mean.deviation.g + 1e-5) << roughness << " " << angle;
            EXPECT_GT(mean.value.g, 0.3);
        }
    }
}

TEST(ReferenceScattering, a_smooth_metal_loses_next_to_nothing) {
    GroundPoint const point = flat(glm::dvec3(1), 1, 0);
    for (double const angle : {0.0, 0.6, 1.2}) {
        EXPECT_NEAR(albedo_by_samples(point, tilted(point.shading, angle), 50'000).value.g, 1, 2e-3) << angle;
    }
}

TEST(ReferenceScattering, a_lambertian_place_gives_its_albedo_with_every_sample) {
    GroundPoint point = flat(glm::dvec3(1), 0, 1);
    point.surface.gloss = 0;
    point.surface.diffuse = glm::dvec3(0.25, 0.5, 1.0);
    for (double const angle : {0.0, 0.8, 1.57}) {
        for (int i = 0; i < 1000; ++i) {
            double const u = (i + 0.5) / 1000;
            auto const sample = sample_reflection(point, tilted(point.shading, angle), u, std::fmod(u * 37, 1.0), u);
            ASSERT_TRUE(sample);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(sample->weight[c], point.surface.diffuse[c], 1e-9);
        }
    }
    EXPECT_NEAR(reflect(point, point.shading, tilted(point.shading, 1.0)).b, std::cos(1.0) / PI, 1e-12);
}

TEST(ReferenceScattering, exchanging_viewer_and_light_changes_the_cosine_only) {
    GroundPoint const point = flat(glm::dvec3(0.8), 0, 0.4);
    glm::dvec3 const a = tilted(point.shading, 0.4, 0.3), b = tilted(point.shading, 1.1, 2.0);
    EXPECT_NEAR(reflect(point, a, b).r / glm::dot(point.shading, b),
                reflect(point, b, a).r / glm::dot(point.shading, a), 1e-6);
}

TEST(ReferenceScattering, no_light_comes_through_the_surface) {
    GroundPoint point = flat(glm::dvec3(0.8), 0, 0.3);
    point.shading = tilted(point.facing, 1.0, 0);
    glm::dvec3 const under_facing = tilted(point.facing, 1.7, 0), under_shading = tilted(point.facing, 1.0, PI);
    ASSERT_GT(glm::dot(under_facing, point.shading), 0);
    ASSERT_LT(glm::dot(under_shading, point.shading), 0);
    EXPECT_EQ(reflect(point, point.facing, under_facing), glm::dvec3(0));
    EXPECT_EQ(reflect(point, point.facing, under_shading), glm::dvec3(0));
    EXPECT_GT(reflect(point, point.facing, point.facing).r, 0);
}

TEST(ReferenceScattering, bumps_that_lean_away_from_the_viewer_are_sampled_right) {
    GroundPoint point = flat(glm::dvec3(0.8), 0.5, 0.4);
    point.shading = tilted(point.facing, 0.6, 0);
    glm::dvec3 const viewer = tilted(point.facing, 1.2, PI); // 1.8 from the bump's normal
    ASSERT_LT(glm::dot(viewer, point.shading), 0);
    // The value jumps at the geometric horizon: the quadrature is good to one step of 1500.
    glm::dvec3 const expected = albedo_by_quadrature(point, viewer, 1500);
    Mean const mean = albedo_by_samples(point, viewer, 200'000);
    EXPECT_GT(expected.g, 0.01);
    EXPECT_NEAR(mean.value.g, expected.g, 4 * mean.deviation.g + 1e-3 * expected.g);
}

} // namespace alpenglow
