#include "core/error.h"
#include "support/files.h"
#include "support/render_test.h"

#include <set>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

class ShowPass : public RenderTest {
protected:
    ByteImage shown(char const* name) {
        Stand const stand = stand_on(load_planet("earth"));
        Scene scene = scene_of({matte({0.3f, 0.25f, 0.2f})});
        scene.materials[0].emission = {0.1f, 0.2f, 0.3f};
        add_plane(scene, 40, 1);
        add_box(scene, {-6, 4, -12}, {3, 3, 3});
        put(scene, stand);
        Settings settings = plain_settings();
        settings.cascade_size = 256;
        settings.show = name;
        return picture(stand.view(stand.camera({0, 6, 12}, {0, 3, -10}, glm::radians(60.0)), sun_at(28, 70)), settings, {64, 36});
    }
};

std::size_t colors(ByteImage const& image) {
    std::set<std::array<int, 3>> found;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) found.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    return found.size();
}

} // namespace

TEST_F(ShowPass, every_image_of_the_frame_has_a_scale_that_shows_it) {
    for (char const* const name : {"transmittance", "multiple_scattering", "shadow", "albedo", "normal", "depth", "lit", "radiance", "cascades"}) {
        EXPECT_GE(colors(shown(name)), 3u) << name;
    }
    for (char const* const name : {"material", "emission"}) EXPECT_GE(colors(shown(name)), 2u) << name; // uniform but for sea and sky
}

TEST_F(ShowPass, an_unknown_name_is_refused_with_those_there_are) {
    expect_error(ErrorKind::wrong_use, {"no image 'dpeth'", "depth", "cascades", "multiple_scattering"}, [&] { shown("dpeth"); });
    EXPECT_GE(colors(shown("")), 3u); // and the renderer goes on
}
