#include "encoding/color.glsl"
#include "encoding/octahedral.glsl"
#include "support/gpu_test.h"

#include <test_shaders.h>

#include <cmath>
#include <random>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{64, 64};

/// Unit vectors in xyz, the axes and the folds of the octahedron among them, and a value from 0 to 1 in w.
std::vector<glm::vec4> directions_and_values() {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<glm::vec4> result;
    for (glm::dvec3 const& axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, -1}, {0, -1, -1}, {1, 1, 1}}) {
        for (double const sign : {1.0, -1.0}) result.push_back(glm::vec4(glm::normalize(sign * axis), 0.0031308f));
    }
    while (result.size() < EXTENT.pixels()) {
        glm::dvec3 const n = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        result.push_back(glm::vec4(glm::vec3(n), float(result.size()) / float(EXTENT.pixels() - 1)));
    }
    return result;
}

class EncodingsOnGpu : public GpuTest {};

} // namespace

TEST_F(EncodingsOnGpu, are_those_of_cpp) {
    auto const input = directions_and_values();
    auto const output = run_compute(device(), shaders::encoding_round_trip_comp, input, EXTENT);
    float octahedral = 0, color = 0;
    for (std::size_t i = 0; i < input.size(); ++i) {
        glm::vec2 const expected = shader::octahedral_from_unit(glm::vec3(input[i]));
        octahedral = std::max(octahedral, glm::length(glm::vec2(output[i]) - expected));
        color = std::max({color, std::abs(output[i].z - shader::srgb_from_linear(input[i].w)), std::abs(output[i].w - shader::linear_from_srgb(input[i].w))});
    }
    EXPECT_LT(octahedral, 1e-6f); // a few roundings of numbers up to 1
    EXPECT_LT(color, 2e-5f);      // a driver's pow; a 300th of a step of 8 bits
}

TEST_F(EncodingsOnGpu, octahedral_vectors_come_back) {
    auto const input = directions_and_values();
    auto const there = run_compute(device(), shaders::encoding_round_trip_comp, input, EXTENT);
    auto const back = run_compute(device(), shaders::octahedral_decode_comp, there, EXTENT);
    float worst = 0;
    for (std::size_t i = 0; i < input.size(); ++i) worst = std::max(worst, glm::length(glm::vec3(back[i]) - glm::vec3(input[i])));
    EXPECT_LT(worst, 1e-6f);
}

TEST(Encodings, octahedral_and_srgb_come_back_in_cpp) {
    for (glm::vec4 const& value : directions_and_values()) {
        glm::vec3 const unit(value);
        ASSERT_LT(glm::length(shader::unit_from_octahedral(shader::octahedral_from_unit(unit)) - unit), 1e-6f);
        ASSERT_NEAR(shader::linear_from_srgb(shader::srgb_from_linear(value.w)), value.w, 2e-6f);
    }
}
