#include "support/render_test.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{64, 36};

/// A bright tilted square in front of black space, so that a pixel's radiance is the share of it that the square covers.
class Supersampling : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        Material glowing = black();
        glowing.emission = glm::vec3(1);
        Scene scene = scene_of({glowing});
        add_quad(scene, {0, 10, 0}, {2.5, 0, 0.93}, {-0.93, 0, 2.5});
        put(scene, stand_);
    }
    FloatImage seen(int aa, Extent extent) {
        Settings settings = plain_settings();
        settings.shadows = false;
        settings.shafts = "off";
        settings.aa = aa;
        return radiance(stand_.view(stand_.camera({0, 0, 0}, {0, 1, 0}, 0.8, {0, 0, 1}), {0, 1, 0.2}), settings, extent);
    }
    Stand stand_ = stand_on(airless_planet(), 1000);
};

/// The square with a picture of a board with black and white fields in no order, about three across a pixel.
Scene board() {
    constexpr std::size_t FIELDS = 64;
    Material glowing = black();
    glowing.emission = glm::vec3(1);
    glowing.emission_texture.picture = 0;
    Scene scene = scene_of({glowing});
    Picture picture{"board", FIELDS, FIELDS, {}};
    std::mt19937 random(1);
    for (std::size_t i = 0; i < FIELDS * FIELDS; ++i) {
        std::uint8_t const value = random() % 2 != 0 ? 255 : 0;
        picture.rgba.insert(picture.rgba.end(), {value, value, value, 255});
    }
    scene.pictures[0] = picture;
    add_quad(scene, {0, 10, 0}, {2.5, 0, 0.93}, {-0.93, 0, 2.5});
    for (Vertex& vertex : scene.meshes[0].vertices) vertex.uv0 = glm::vec2(vertex.position.x, vertex.position.z) / 5.0f;
    return scene;
}

/// The mean of blocks of `side` x `side` pixels.
FloatImage reduced(FloatImage const& image, std::uint32_t side) {
    FloatImage result(EXTENT);
    for (std::uint32_t y = 0; y < image.extent.height; ++y) {
        for (std::uint32_t x = 0; x < image.extent.width; ++x) *result.at(x / side, y / side) += *image.at(x, y) / static_cast<float>(side * side);
    }
    return result;
}

struct Difference {
    double largest = 0, mean = 0, bias = 0;
};

Difference difference(FloatImage const& a, FloatImage const& b) {
    Difference result;
    for (std::uint32_t i = 0; i < EXTENT.pixels(); ++i) {
        double const d = a.rgba[4 * i] - b.rgba[4 * i];
        result.largest = std::max(result.largest, std::abs(d));
        result.mean += std::abs(d) / static_cast<double>(EXTENT.pixels());
        result.bias += d / static_cast<double>(EXTENT.pixels());
    }
    return result;
}

} // namespace

TEST_F(Supersampling, converges_to_the_covered_share_of_each_pixel) {
    constexpr std::uint32_t FINE = 16;
    FloatImage const exact = reduced(seen(1, {FINE * EXTENT.width, FINE * EXTENT.height}), FINE);
    Difference const one = difference(seen(1, EXTENT), exact), four = difference(seen(4, EXTENT), exact), sixteen = difference(seen(16, EXTENT), exact);
    EXPECT_GT(one.largest, 0.4);
    EXPECT_LT(four.largest, 0.3);     // an edge splits four points at most one off its share, which is a quarter
    EXPECT_LT(sixteen.largest, 0.125); // and sixteen at most two
    EXPECT_LT(four.mean, 0.5 * one.mean);
    EXPECT_LT(sixteen.mean, 0.5 * four.mean);
    // No shift: the samples' centre is the pixel's.
    EXPECT_LT(std::abs(sixteen.bias), 2e-4);
}

// Rays that lie closer than pixels read finer mipmaps: else a picture is blurred twice.
TEST_F(Supersampling, shows_pictures_as_sharp_as_a_pixels_mean) {
    put(board(), stand_);
    constexpr std::uint32_t FINE = 16;
    FloatImage const exact = reduced(seen(1, {FINE * EXTENT.width, FINE * EXTENT.height}), FINE);
    Difference const one = difference(seen(1, EXTENT), exact), four = difference(seen(4, EXTENT), exact), sixteen = difference(seen(16, EXTENT), exact);
    EXPECT_LT(four.mean, 0.7 * one.mean);
    EXPECT_LT(sixteen.mean, 0.3 * one.mean);
}

TEST_F(Supersampling, is_the_same_every_time) {
    EXPECT_EQ(seen(4, EXTENT).rgba, seen(4, EXTENT).rgba);
}
