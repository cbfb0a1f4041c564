#include "support/render_test.h"

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

class PixelWork : public RenderTest {
protected:
    /// A slanted horizon behind a pole that reaches over it, in a picture of that size.
    void draw(Extent extent, int aa) {
        Scene scene = scene_of({matte(glm::vec3(0.5))});
        add_quad(scene, {0.3, 2, -5}, {0.4, 0, 0}, {0, 4, 0});
        put(scene, stand_);
        Settings settings = plain_settings();
        settings.ambient_occlusion = true;
        settings.aa = aa;
        renderer().draw(stand_.view(stand_.camera({0, 2, 0}, {0, 2, -1}, 1, {0.3, 1, 0}), {0, 1, 0}), settings, extent);
    }
    Stand const stand_ = stand_on(load_planet("earth"));
};

} // namespace

// Each pixel is one pass's or the other's, in whole blocks and in those that reach out of the picture. Both write an alpha of 1 into an
// image that was cleared to 0.
TEST_F(PixelWork, lights_every_pixel_and_occludes_no_sky) {
    for (int const aa : {1, 4})
        for (Extent const extent : {Extent{64, 64}, Extent{61, 37}, Extent{17, 129}}) {
            draw(extent, aa);
            auto const lit = values_of<glm::vec4>(renderer().image_bytes("lit"));
            auto const depth = values_of<float>(renderer().image_bytes("depth"));
            auto const open = values_of<float>(renderer().image_bytes("ambient_occlusion"));
            ASSERT_EQ(lit.size(), extent.pixels());
            std::size_t unlit = 0, sky = 0, occluded_sky = 0, occluded = 0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                unlit += lit[i].a != 1;
                sky += depth[i] == 0;
                (depth[i] == 0 ? occluded_sky : occluded) += open[i] != 1;
            }
            EXPECT_EQ(unlit, 0u) << extent.width << 'x' << extent.height;
            EXPECT_EQ(occluded_sky, 0u);
            EXPECT_GT(occluded, 0u);
            EXPECT_GT(sky, lit.size() / 10);
            EXPECT_LT(sky, lit.size() * 9 / 10);
        }
}
