#include "support/render_test.h"

#include <cmath>
#include <cstring>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{96, 96};

/// A floor before a wall, both seen whole.
class AmbientOcclusionPass : public RenderTest {
protected:
    std::vector<float> drawn(Scene const& scene, bool on) {
        Stand const stand = stand_on(load_planet("earth"), 100);
        put(scene, stand);
        Settings settings = plain_settings();
        settings.ambient_occlusion = on;
        settings.model = "naive"; // it has no tables to make
        world_ = stand.view(stand.camera({0, 30, 0}, {0, 0, -0.01}, glm::radians(80.0), {0, 0, -1}), sun_at(60, 0));
        renderer().draw(world_, settings, EXTENT);
        std::vector<std::byte> const bytes = renderer().image_bytes("ambient_occlusion");
        std::vector<float> values(bytes.size() / sizeof(float));
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    World world_{};
};

float at(std::vector<float> const& image, std::uint32_t x, std::uint32_t y) { return image[y * EXTENT.width + x]; }

} // namespace

TEST_F(AmbientOcclusionPass, an_open_plane_sees_all_of_the_sky) {
    Scene scene = scene_of({matte({0.3f, 0.3f, 0.3f})});
    add_plane(scene, 60, 0);
    for (float const value : drawn(scene, true)) ASSERT_NEAR(value, 1, 0.015); // at the edges some of the sixteen directions lack
}

TEST_F(AmbientOcclusionPass, a_wall_hides_what_its_form_factor_says) {
    // From above; a wall of 4 m, leaning so little that its face is seen, across the floor at x = 0.
    Scene scene = scene_of({matte({0.3f, 0.3f, 0.3f})});
    add_plane(scene, 60, 0);
    add_box(scene, {-4, 2, 0}, {4, 2, 40});
    std::vector<float> const image = drawn(scene, true);
    double const metres = 2 * 30 * std::tan(glm::radians(40.0)) / EXTENT.height;
    for (double const d : {1.5, 3.0, 6.0, 12.0}) {
        auto const x = static_cast<std::uint32_t>(0.5 * EXTENT.width + d / metres);
        double const middle = (x + 0.5 - 0.5 * EXTENT.width) * metres; // of the pixel
        double const seen = 0.5 * (1 + middle / std::hypot(middle, 4.0));
        EXPECT_NEAR(at(image, x, EXTENT.height / 2), seen, 0.06) << d << " m from a wall of 4 m";
    }
    for (float const value : drawn(scene, false)) EXPECT_EQ(value, 1);
}
