#include "scene/studio.h"

#include "encoding/color.glsl"
#include "support/gltf_builder.h"
#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent SIZE{64, 64};
using Rgb = std::array<int, 3>;

Rgb rgb(ByteImage const& picture, std::uint32_t x, std::uint32_t y) {
    std::uint8_t const* const p = picture.at(x, y);
    return {p[0], p[1], p[2]};
}

/// A material of one primitive's scene: `color`, no metal, no gloss.
void add_matte(GltfBuilder& builder, std::array<double, 4> const& color, bool unlit) {
    nlohmann::json extensions = {{"KHR_materials_specular", {{"specularFactor", 0}}}};
    if (unlit) extensions = {{"KHR_materials_unlit", nlohmann::json::object()}};
    builder.json["extensionsUsed"] = {extensions.begin().key()};
    builder.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0}}}, {"extensions", extensions}}};
}

/// A square across Z, its front to +Z; its lower left corner is where the file's origin is.
Scene board(float side, std::array<double, 4> const& color, bool unlit) {
    GltfBuilder builder;
    add_matte(builder, color, unlit);
    builder.show({{"POSITION", builder.add<float>("VEC3", {0, 0, 0, side, 0, 0, side, side, 0, 0, side, 0})}},
                 {{"indices", builder.add<std::uint16_t>("SCALAR", {0, 1, 2, 0, 2, 3})}, {"material", 0}});
    return builder.load();
}

/// Three faces of a cube: right, top and front, which the studio's camera sees.
Scene corner_of_cube(float side) {
    GltfBuilder builder;
    add_matte(builder, {1, 1, 1, 1}, false);
    float const s = side;
    builder.show({{"POSITION", builder.add<float>("VEC3", {s, 0, s, s, 0, 0, s, s, 0, s, s, s,   // right
                                                           0, s, s, s, s, s, s, s, 0, 0, s, 0,   // top
                                                           0, 0, s, s, 0, s, s, s, s, 0, s, s})}}, // front
                 {{"indices", builder.add<std::uint16_t>(
                                  "SCALAR", {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 9, 10, 8, 10, 11})},
                  {"material", 0}});
    return builder.load();
}

class StudioPass : public RenderTest {
protected:
    ByteImage shoot(Scene const& scene) {
        shot_ = make_studio_shot(scene.bounds, 1);
        renderer().set_scene(&scene, shot_.placement, shot_.world.planet.radius);
        return picture(shot_.world, studio_settings(), SIZE);
    }
    StudioShot shot_;
};

constexpr float SIDES[] = {1e-3f, 1.0f, 1e5f}; // [m]

} // namespace

TEST_F(StudioPass, an_unlit_board_shows_its_colour_fills_the_picture_and_leaves_the_backdrop_even) {
    for (float const side : SIDES) {
        ByteImage const picture = shoot(board(side, {1, 0.214041, 0, 1}, true)); // sRGB 255, 127.5, 0
        Rgb const backdrop = rgb(picture, 0, 0), middle = rgb(picture, 32, 32);
        // The G-buffer holds the linear value within 1/128, half of that as sRGB.
        EXPECT_NEAR(middle[0], 255, 1);
        EXPECT_NEAR(middle[1], 127.5, 1.5);
        EXPECT_EQ(middle[2], 0);
        EXPECT_GT(backdrop[0], 40);
        EXPECT_EQ(backdrop[0], backdrop[2]);
        for (std::uint32_t y = 0; y < SIZE.height; ++y) {
            for (std::uint32_t x = 0; x < SIZE.width; ++x) {
                // The board is 92 % of the picture: its edges are 2.56 pixels inside.
                std::uint32_t const inset = std::min({x, y, SIZE.width - 1 - x, SIZE.height - 1 - y});
                if (inset == 2) continue;
                EXPECT_EQ(rgb(picture, x, y), inset < 2 ? backdrop : middle) << side << " m at " << x << ", " << y;
            }
        }
    }
}

TEST_F(StudioPass, a_white_board_is_as_bright_as_its_angle_to_the_key_light_says) {
    for (float const side : SIDES) {
        ByteImage const picture = shoot(board(side, {1, 1, 1, 1}, false));
        double const cosine = glm::dot(shot_.world.to_sun, shot_.world.camera.world_from_camera[2]);
        double const key = shot_.world.planet.solar_irradiance.x, fill = key * shot_.world.studio->fill.x;
        EXPECT_NEAR(key + fill, 1, 1e-12);
        float const displayed = shader::srgb_from_linear(static_cast<float>(key * cosine + fill));
        for (int const channel : rgb(picture, 32, 32)) EXPECT_NEAR(channel, 255 * displayed, 2) << side << " m";
    }
}

TEST_F(StudioPass, a_cube_is_seen_from_the_right_and_above_with_three_faces_lit_before_an_even_backdrop) {
    for (float const side : SIDES) {
        ByteImage const picture = shoot(corner_of_cube(side));
        Rgb const backdrop = rgb(picture, 0, 0);
        std::size_t things = 0;
        std::array<std::size_t, 256> histogram{};
        for (std::uint32_t y = 0; y < SIZE.height; ++y) {
            for (std::uint32_t x = 0; x < SIZE.width; ++x) {
                Rgb const at = rgb(picture, x, y);
                bool const at_edge = std::min({x, y, SIZE.width - 1 - x, SIZE.height - 1 - y}) < 2;
                if (at_edge) {
                    EXPECT_EQ(at, backdrop) << side << " m at " << x << ", " << y;
                }
                things += at != backdrop;
                ++histogram[static_cast<std::size_t>(at[0])];
            }
        }
        // A cube's hexagon in a square, 92 % of it high.
        EXPECT_NEAR(static_cast<double>(things) / static_cast<double>(SIZE.pixels()), 0.58, 0.1) << side;
        // Four flat greys, the backdrop's and the faces': next to nothing else but edges.
        std::ranges::sort(histogram, std::greater());
        EXPECT_GT(histogram[3], 200u) << side;
        EXPECT_GT(histogram[0] + histogram[1] + histogram[2] + histogram[3], SIZE.pixels() * 85 / 100) << side;
    }
}
