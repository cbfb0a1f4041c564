#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{96, 54};
constexpr double FIELD = 60; // [degrees], vertical: a pixel is 1 degree wide

/// What the air adds and lets through, for each pixel.
struct AirLayers {
    std::vector<glm::vec4> inscattered, transmittance;
};

double luminance(glm::vec4 const& v) { return 0.2126 * v.r + 0.7152 * v.g + 0.0722 * v.b; }
double largest(glm::vec4 const& v) { return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b)}); }

/// Pixels' errors as the repair judges them, sorted: in what the air lets through, or in what it adds, as a share of its light there.
/// Light that is fainter than a quarter of the picture's mean counts as that, and brighter than twice the mean as that.
std::vector<double> errors(AirLayers const& air, AirLayers const& exact) {
    double mean = 0;
    for (glm::vec4 const& v : exact.inscattered) mean += luminance(v) / static_cast<double>(EXTENT.pixels());
    std::vector<double> result;
    for (std::size_t i = 0; i < EXTENT.pixels(); ++i) {
        double const bright = std::clamp(luminance(exact.inscattered[i]), 0.25 * mean, 2 * mean);
        result.push_back(std::max(largest(air.inscattered[i] - exact.inscattered[i]) / bright,
                                  largest(air.transmittance[i] - exact.transmittance[i])));
    }
    std::ranges::sort(result);
    return result;
}

/// The error that this share of the pixels stays below.
double share_below(std::vector<double> const& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double permille_above(std::vector<double> const& sorted) { return share_below(sorted, 0.999); }

/// `exact` at every `stride`-th pixel each way, and linear between them.
AirLayers unrepaired(AirLayers const& exact, std::uint32_t stride) {
    auto const between = [stride](std::vector<glm::vec4> const& image) {
        std::vector<glm::vec4> result;
        for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
            std::uint32_t const x = i % EXTENT.width, y = i / EXTENT.width, x0 = x - x % stride, y0 = y - y % stride;
            std::uint32_t const x1 = std::min(x0 + stride, EXTENT.width - 1), y1 = std::min(y0 + stride, EXTENT.height - 1);
            auto const at = [&](std::uint32_t column, std::uint32_t row) { return image[row * EXTENT.width + column]; };
            float const u = float(x - x0) / float(stride), v = float(y - y0) / float(stride);
            result.push_back(glm::mix(glm::mix(at(x0, y0), at(x1, y0), u), glm::mix(at(x0, y1), at(x1, y1), u), v));
        }
        return result;
    };
    return {between(exact.inscattered), between(exact.transmittance)};
}

struct Level {
    char const* shafts;
    int samples;
    double tolerance; // of render/passes/air.cpp
};

struct Case {
    char const* name;
    Scene scene;
    glm::dvec3 eye, target; // [m]
    glm::dvec3 to_sun;
    double permille = 0, worst = 0; // errors of a pixel in a thousand, and of the worst, that no tolerance bounds
};

/// As wide as a pixel, before the sky and the sun.
Case masts() {
    Case made{"masts", scene_of({matte(glm::vec3(0.1f))}), {0, 5, 0}, {0, 180, -600}, sun_at(18, 8)};
    for (int i = -9; i <= 9; ++i) add_box(made.scene, {61.0 * i, 150, -600}, {5, 150 + 4 * i, 5});
    return made;
}

/// Twelve kilometres of it, before haze that the sun shines through.
Case ridge() {
    Case made{"ridge", scene_of({matte(glm::vec3(0.1f))}), {0, 50, 0}, {0, 400, -4000}, sun_at(14, -15)};
    add_ridge(made.scene, {-6000, 0, -3000}, {6000, 0, -6500}, 900, 900);
    return made;
}

/// At arm's length against what is before the ground kilometres behind it: edges between pixels that don't know of them.
Case wall() {
    Case made{"wall", scene_of({matte(glm::vec3(0.1f))}), {0, 300, 0}, {0, 250, -600}, sun_at(25, 100), 0.015, 0.024};
    add_box(made.scene, {-30, 280, -60}, {28, 12, 1});
    add_quad(made.scene, {25, 300, -50}, {2, 20, 0}, {8, 0, -3});
    return made;
}

class AirRepair : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        settings_ = plain_settings();
        settings_.cascade_size = 512;
        settings_.ceiling_size = 256;
    }
    FloatImage draw(World const& world, char const* shafts, int stride) {
        settings_.shafts = shafts;
        settings_.air_stride = std::to_string(stride);
        return radiance(world, settings_, EXTENT);
    }
    AirLayers air(Case const& given, char const* shafts, int stride) {
        draw(stand_.view(stand_.camera(given.eye, given.target, glm::radians(FIELD)), given.to_sun), shafts, stride);
        return {values_of<glm::vec4>(renderer().image_bytes("air_inscattered")),
                values_of<glm::vec4>(renderer().image_bytes("air_transmittance"))};
    }
    Stand stand_ = stand_on(load_planet("misty"));
    Settings settings_;
};

} // namespace

// The disc stands on a pixel between those that are marched; behind thick air it is what lets errors of transmittance be seen first.
TEST_F(AirRepair, leaves_the_suns_disc_as_bright_as_it_is) {
    constexpr std::uint32_t X = 49, Y = 27;
    settings_.sun_disc = true;
    for (char const* const planet : {"earth", "misty"}) {
        stand_ = stand_on(load_planet(planet));
        for (double const elevation : {5.0, 15.0}) {
            Camera const camera = stand_.camera({0, 20, 0}, glm::dvec3(0, 20, 0) + sun_at(elevation, 0), glm::radians(FIELD));
            World const world{stand_.planet, camera, pixel_direction(camera, EXTENT, X, Y)};
            FloatImage const exact = draw(world, "fast", 1);
            double const disc = pixel(exact, X, Y).g;
            EXPECT_GT(disc, 10 * pixel(exact, X - 1, Y).g); // it is there
            for (int const stride : {2, 4}) {
                FloatImage const drawn = draw(world, "fast", stride);
                EXPECT_NEAR(pixel(drawn, X, Y).g / disc, 1, 0.01) << planet << ", sun at " << elevation << ", stride " << stride;
                EXPECT_GE(*std::ranges::min_element(drawn.rgba), 0);
            }
        }
    }
}

// The pass's own tolerances bound interpolation's error by what the pixels around lead to expect. Before the sun errors are judged by
// the picture's mean light: judged by the light there they would be over the bounds.
TEST_F(AirRepair, is_as_close_to_air_marched_everywhere_as_its_tolerance_says) {
    for (Level const& level : {Level{"default", 16, 0.006}, Level{"default", 4, 0.096}, Level{"fast", 16, 0.1}}) {
        settings_.samples = level.samples;
        for (Case const& given : {masts(), ridge(), wall()}) {
            put(given.scene, stand_);
            AirLayers const exact = air(given, level.shafts, 1);
            for (int const stride : {2, 4}) {
                std::vector<double> const found = errors(air(given, level.shafts, stride), exact);
                EXPECT_LT(permille_above(found), std::max(0.8 * level.tolerance, given.permille)) << given.name << ", " << level.shafts << ", " << level.samples << " samples, stride " << stride;
                EXPECT_LT(found.back(), std::max(1.2 * level.tolerance, given.worst)) << given.name << ", " << level.shafts << ", " << level.samples << " samples, stride " << stride;
            }
        }
    }
}

// From orbit: what misses the air sends nothing, and nothing comes to it from the rays beside it.
TEST_F(AirRepair, leaves_space_black) {
    stand_ = stand_on(load_planet("earth"), 4e5);
    Case const given{"limb", {}, {0, 0, 0}, sun_at(-19.5, 0), sun_at(30, 40)};
    AirLayers const exact = air(given, "default", 1);
    for (int const stride : {2, 4}) {
        AirLayers const drawn = air(given, "default", stride);
        int black = 0;
        for (std::size_t i = 0; i < EXTENT.pixels(); ++i) {
            if (largest(exact.inscattered[i]) > 0) continue;
            ++black;
            EXPECT_EQ(largest(drawn.inscattered[i]), 0) << "pixel " << i << ", stride " << stride;
        }
        EXPECT_GT(black, 500);
        EXPECT_LT(black, int(EXTENT.pixels()) - 500);
    }
}

// Some drivers end a shader's loops after so many turns: what is marched must not share them.
TEST_F(AirRepair, marches_many_samples_to_their_end) {
    Case const given = masts();
    put(given.scene, stand_);
    settings_.samples = 256;
    AirLayers const exact = air(given, "default", 1);
    EXPECT_LT(errors(air(given, "default", 4), exact).back(), 0.04);
}

TEST_F(AirRepair, is_worse_with_a_larger_tolerance_and_useless_if_left_out) {
    for (Case const& given : {masts(), ridge(), wall()}) {
        put(given.scene, stand_);
        std::vector<double> const fine = errors(air(given, "default", 4), air(given, "default", 1));
        AirLayers const exact = air(given, "fast", 1);
        std::vector<double> const coarse = errors(air(given, "fast", 4), exact);
        EXPECT_GT(share_below(coarse, 0.95), 3 * share_below(fine, 0.95)) << given.name;
        // Skylines are more than a thousandth of the picture, and whole rays are at stake there.
        for (std::uint32_t const stride : {2u, 4u}) EXPECT_GT(permille_above(errors(unrepaired(exact, stride), exact)), 1) << given.name;
    }
}

// The rays themselves are farther off then.
TEST_F(AirRepair, is_worse_between_rays_of_few_samples) {
    Case const given = ridge();
    put(given.scene, stand_);
    auto const typical = [&](int samples) {
        settings_.samples = samples;
        return share_below(errors(air(given, "default", 4), air(given, "default", 1)), 0.95);
    };
    double const of_sixteen = typical(16);
    EXPECT_GT(typical(8), 1.5 * of_sixteen);
    EXPECT_GT(typical(4), 3 * of_sixteen);
}
