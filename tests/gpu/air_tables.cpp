#include "render/frame_constants.h"
#include "support/air.h"
#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

class AirTablesOnGpu : public RenderTest, public ::testing::WithParamInterface<char const*> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        std::string const name = GetParam();
        Stand const stand = stand_on(name == "motley" ? motley_planet() : load_planet(name));
        air_ = atmosphere_of(stand.planet);
        renderer().draw(stand.view(stand.camera({0, 10, 0}, {0, 10, -1}, 1), {0, 1, 0}), plain_settings(), {8, 8});
    }
    std::vector<glm::vec4> table(char const* name) { return values_of<glm::vec4>(renderer().image_bytes(name)); }

    shader::Atmosphere air_{};
};

/// The largest difference of two tables.
float largest_difference(std::vector<glm::vec4> const& a, std::vector<glm::vec4> const& b, std::size_t every) {
    EXPECT_EQ(a.size(), b.size() * every);
    float largest = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        glm::vec3 const difference = glm::abs(glm::vec3(a[i * every]) - glm::vec3(b[i]));
        // Where nothing is left the floor of the logarithm is stored; it is the same on both sides, or both are below 1e-20.
        for (int c = 0; c < 3; ++c) {
            if (std::max(a[i * every][c], b[i][c]) > -46.0f) largest = std::max(largest, difference[c]);
        }
        if (!std::isfinite(difference.x + difference.y + difference.z)) return INFINITY;
    }
    return largest;
}

/// Every `stride`th row and column of a table in C++, at the same nodes as the GPU's.
template <typename Texel>
std::vector<glm::vec4> in_cpp(int width, int height, int every, Texel const& texel) {
    std::vector<glm::vec4> result;
    for (int i = 0; i < width * height; i += every) {
        result.push_back(texel(glm::vec2((float(i % width) + 0.5f) / float(width), (float(i / width) + 0.5f) / float(height))));
    }
    return result;
}

} // namespace

// The driver's exp and log are off by 1e-6 and sums of 100 terms by ten times that; a wrong sign or slot is off by percents.
constexpr float SAME = 1e-4f;             // of logarithms: relative
constexpr float SAME_ROOT = SAME / 32.0f; // of 32nd roots

TEST_P(AirTablesOnGpu, are_those_that_cpp_computes) {
    Table const transmittance = make_transmittance_table(air_);
    EXPECT_LT(largest_difference(table("transmittance"), transmittance.texels(), 1), SAME);

    Table const multiple = make_multiple_scattering_table(air_, transmittance);
    EXPECT_LT(largest_difference(table("multiple_scattering"), multiple.texels(), 1), SAME_ROOT);

    constexpr int EVERY = 8; // each costs 12 000 march steps
    auto const irradiance = in_cpp(SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT, EVERY, [&](glm::vec2 uv) {
        glm::vec2 const node = shader::altitude_sun_from_uv(air_, uv, SKY_IRRADIANCE_WIDTH, SKY_IRRADIANCE_HEIGHT);
        return shader::sky_irradiance_texel(shader::compute_sky_irradiance(air_, transmittance.sampler(), multiple.sampler(), node.x, node.y));
    });
    EXPECT_LT(largest_difference(table("sky_irradiance"), irradiance, EVERY), SAME_ROOT);
}

INSTANTIATE_TEST_SUITE_P(Planets, AirTablesOnGpu, ::testing::Values("earth", "dense", "motley"), [](auto const& given) { return std::string(given.param); });

class AirTablesInFrames : public RenderTest {};

TEST_F(AirTablesInFrames, are_made_anew_when_the_air_changes_and_only_then) {
    Stand stand = stand_on(load_planet("earth"));
    World world = stand.view(stand.camera({0, 10, 0}, {0, 10, -1}, 1), {0, 1, 0});
    auto const makes_tables = [&] {
        renderer().draw(world, plain_settings(), {8, 8});
        renderer().wait();
        return std::ranges::any_of(renderer().timings(), [](PassTime const& time) { return time.name == "transmittance"; });
    };
    makes_tables();
    EXPECT_FALSE(makes_tables());
    world.planet.air.at("aerosol").phase.g = 0.7;
    EXPECT_TRUE(makes_tables());
    EXPECT_FALSE(makes_tables());
}
