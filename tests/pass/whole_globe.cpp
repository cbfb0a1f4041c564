#include "support/render_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{160, 90};

class WholeGlobe : public RenderTest {
protected:
    /// A box and a ridge on a plate, with the same sun in their own frame.
    ByteImage seen_at(double latitude, double longitude) {
        Scene scene = scene_of({matte({0.3f, 0.25f, 0.2f}), matte({0.5f, 0.5f, 0.5f})});
        add_plane(scene, 40, 1);
        add_box(scene, {-6, 4, -12}, {3, 3, 3}, 1);
        add_ridge(scene, {8, 1, -40}, {8, 1, -10}, 5, 7, 1);
        Stand stand = stand_on(airless_planet());
        stand.placement.anchor = {glm::radians(latitude), glm::radians(longitude), 300};
        put(scene, stand);
        return picture(stand.view(stand.camera({0, 6, 12}, {0, 3, -10}, glm::radians(60.0)), sun_at(28, 70)), plain_settings(), EXTENT);
    }
};

/// Bytes that differ by more than one.
int differing(ByteImage const& a, ByteImage const& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) count += std::abs(a.rgba[i] - b.rgba[i]) > 1;
    return count;
}

} // namespace

TEST_F(WholeGlobe, a_scene_looks_the_same_anywhere) {
    ByteImage const here = seen_at(46, 7.5);
    EXPECT_GT(differing(here, ByteImage(EXTENT)), 20000); // it is a picture
    EXPECT_EQ(differing(here, seen_at(0, 0)), 0) << "equator";
    EXPECT_EQ(differing(here, seen_at(90, 0)), 0) << "north pole";
    EXPECT_EQ(differing(here, seen_at(-90, 33)), 0) << "south pole";
    EXPECT_EQ(differing(here, seen_at(-17, 180)), 0) << "date line";
    EXPECT_EQ(differing(here, seen_at(63.1, -122.7)), 0);
}
