#include "interop/shadow_bounds.h"
#include "support/render_test.h"

#include <algorithm>
#include <bit>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

struct Bounds {
    float least = 1, greatest = 0;

    void include(float depth) { least = std::min(least, depth), greatest = std::max(greatest, depth); }
    bool operator==(Bounds const&) const = default;
};

/// Boxes of many heights, so that hardly two blocks of a cascade are alike.
Scene many_boxes() {
    Scene scene = scene_of({matte(glm::vec3(0.5))});
    add_plane(scene, 400);
    for (int i = 0; i < 150; ++i) {
        double const away = 2 + 2.5 * i, angle = 2.4 * i, height = 1 + (i * 7 % 13);
        add_box(scene, {away * std::cos(angle), height, away * std::sin(angle)}, {1 + 0.02 * i, height, 1 + 0.03 * i});
    }
    return scene;
}

class ShadowBounds : public RenderTest {
protected:
    void draw(int cascades, int size, Settings settings = plain_settings()) {
        put(many_boxes(), stand_);
        settings.cascades = cascades;
        settings.cascade_size = size;
        settings.ceiling_size = 0;
        settings.shadow_reach = 400;
        renderer().draw(stand_.view(stand_.camera({0, 5, 0}, {0, 4, -10}, 1), sun_at(35, 130)), settings, {8, 8});
        size_ = size;
        cascades_ = cascades;
        side_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>((size + SHADOW_BLOCK - 1) / SHADOW_BLOCK)));
        depths_ = values_of<float>(renderer().image_bytes("shadow"));
        ASSERT_EQ(depths_.size(), std::size_t(cascades) * std::size_t(size) * std::size_t(size));
    }
    std::vector<glm::vec2> image(char const* name) const { return values_of<glm::vec2>(renderer().image_bytes(name)); }

    /// Of a block and the `reach` - 1 blocks behind it in x, in y and in both, as far as the level goes. Beyond the cascade's edge
    /// are its last texels.
    Bounds reduced(int cascade, int level, glm::ivec2 block, int reach) const {
        glm::ivec2 const behind = glm::min(block + reach, glm::ivec2(side_ >> level));
        glm::ivec2 const first = glm::min(block * (SHADOW_BLOCK << level), glm::ivec2(size_ - 1));
        glm::ivec2 const last = glm::min(behind * (SHADOW_BLOCK << level), glm::ivec2(size_)) - 1;
        Bounds bounds;
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) bounds.include(depths_[std::size_t((cascade * size_ + y) * size_ + x)]);
        }
        return bounds;
    }
    /// How many blocks of the image, each looked up `shift` blocks away, differ from the reduction.
    int wrong(std::vector<glm::vec2> const& image, int reach, int shift = 0) const {
        int count = 0, width = side_ + (side_ + 1) / 2;
        for (int cascade = 0; cascade < cascades_; ++cascade) {
            for (int level = 0; side_ >> level > 0; ++level) {
                int const side = side_ >> level;
                glm::ivec2 const origin = shader::bounds_origin(side_, level, cascade);
                for (int i = 0; i < side * side; ++i) {
                    glm::ivec2 const block(i % side, i / side);
                    glm::ivec2 const at = origin + glm::min(block + glm::ivec2(shift, 0), glm::ivec2(side - 1));
                    glm::vec2 const held = image.at(std::size_t(at.y * width + at.x));
                    count += Bounds{held.x, held.y} != reduced(cascade, level, block, reach);
                }
            }
        }
        return count;
    }

    Stand stand_ = stand_on(airless_planet());
    int size_ = 0, cascades_ = 0, side_ = 0;
    std::vector<float> depths_;
};

} // namespace

// Least and greatest of the same floats: equal to the bit.
TEST_F(ShadowBounds, are_those_of_each_block_and_of_the_blocks_behind_it) {
    for (int const cascades : {1, 4}) {
        for (int const size : {512, 300}) { // 300: 37.5 blocks along a side of 64
            draw(cascades, size);
            EXPECT_EQ(wrong(image("shadow_blocks"), 1), 0) << cascades << " cascades of " << size;
            EXPECT_EQ(wrong(image("shadow_bounds"), 2), 0) << cascades << " cascades of " << size;
        }
    }
}

TEST_F(ShadowBounds, are_not_made_where_no_ray_looks_for_shafts) {
    Settings without = plain_settings(), other_model = plain_settings();
    without.shafts = "off";
    other_model.model = "tables";
    for (Settings const& settings : {without, other_model}) {
        draw(4, 512, settings);
        EXPECT_EQ(image("shadow_bounds").size(), 4 * shader::bounds_width(1));
    }
}

TEST_F(ShadowBounds, would_be_noticed_if_they_were_those_of_other_blocks) {
    draw(4, 300);
    std::vector<glm::vec2> const blocks = image("shadow_blocks"), bounds = image("shadow_bounds");
    EXPECT_GT(wrong(bounds, 2, 1), 1000); // of 21 844 that there are
    EXPECT_GT(wrong(blocks, 2), 1000);    // without those behind them
    EXPECT_GT(wrong(bounds, 3), 1000);
}
