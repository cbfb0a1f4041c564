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

/// The largest difference of two tables of roots, where one of them is above `least`.
float largest_difference(std::vector<glm::vec4> const& a, std::vector<glm::vec4> const& b, float least) {
    EXPECT_EQ(a.size(), b.size());
    float largest = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        glm::vec3 const difference = glm::abs(glm::vec3(a[i]) - glm::vec3(b[i]));
        for (int c = 0; c < 3; ++c)
            if (std::max(a[i][c], b[i][c]) > least) largest = std::max(largest, difference[c]);
        if (!std::isfinite(difference.x + difference.y + difference.z)) return INFINITY;
    }
    return largest;
}

/// Per unit of sunlight [1/sr]; a starlit sky has a million times as much. Deeper in the planet's shadow light has come a longer way than
/// the rounds carry it.
constexpr float DARKEST = 1e-15f;

/// The largest difference of a node's texels, in a table of moments and summed anew: relative in the mean, absolute in what is
/// relative to it.
float largest_difference(std::vector<glm::vec4> const& table, std::size_t node, NodeMoments const& sums) {
    float largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        shader::Moments const packed = shader::packed_moments(sums[channel]);
        if (sums[channel].part[0].x < DARKEST) continue;
        for (std::size_t part = 0; part < LIGHT_PARTS; ++part) {
            glm::vec4 const texel = table[(LIGHT_PARTS * channel + part) * LightTable::nodes() + node];
            glm::vec4 const difference = glm::abs(texel - packed.part[part]) * glm::vec4(part == 0 ? 32 : 1, 1, 1, 1);
            for (int i = 0; i < 4; ++i) largest = std::max(largest, difference[i]);
            if (!std::isfinite(glm::dot(difference, glm::vec4(1)))) return INFINITY;
        }
    }
    return largest;
}

} // namespace

// The driver's exp and log are off by 1e-6 and sums of 100 terms by ten times that; a wrong sign or slot is off by percents.
constexpr float SAME = 1e-4f;             // of logarithms: relative
// Root of an optical depth of 1e-4, from which a mean of transmittances is off by a few 1e-7.
constexpr float THIN = 0.75f;
// One round more changes the table by as little.
constexpr float CONVERGED = 0.002f;

TEST_P(AirTablesOnGpu, are_those_that_cpp_computes_and_a_fixed_point) {
    Table const sunlight = make_sunlight_table(air_);
    EXPECT_LT(largest_difference(table("transmittance"), make_transmittance_table(air_).texels(), 0), SAME);
    EXPECT_LT(largest_difference(table("sunlight"), sunlight.texels(), THIN), SAME);

    std::vector<glm::vec4> const first_order = table("first_order"), moments = table("multiple_scattering");
    constexpr std::size_t EVERY = 61; // each costs 15 000 march steps
    shader::sampler2D const light{MULTIPLE_SCATTERING_WIDTH, LIGHT_TILES * MULTIPLE_SCATTERING_HEIGHT, moments.data()};
    for (std::size_t node = 0; node < LightTable::nodes(); node += EVERY) {
        glm::vec2 const place = LightTable::place(air_, node);
        NodeMoments sums = gather_moments(air_, shader::FIRST_ORDER_RAYS, place, [&](shader::AirRay const& ray) {
            return shader::first_order_light(air_, sunlight.sampler(), ray, shader::FIRST_ORDER_RAYS.cells);
        });
        EXPECT_LT(largest_difference(first_order, node, sums), SAME) << place.x << " m, " << place.y;
        NodeMoments const again = gather_moments(air_, shader::HIGHER_ORDER_RAYS, place, [&](shader::AirRay const& ray) {
            return shader::scattered_light(air_, light, ray, shader::HIGHER_ORDER_RAYS.cells);
        });
        for (std::size_t c = 0; c < 3; ++c) sums[c] = shader::sum_of(sums[c], again[c]);
        EXPECT_LT(largest_difference(moments, node, sums), CONVERGED) << place.x << " m, " << place.y;
    }
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
