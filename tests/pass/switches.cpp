#include "support/render_test.h"

#include <thread>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{34, 18};

/// A renderer as a window has it, and one that obeys at once.
class SwitchesInFlight : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        add_plane(scene_, 40, 1);
        add_box(scene_, {-6, 4, -12}, {3, 3, 3});
        settings_.model = "naive"; // fewest pipelines, and no tables
        settings_.samples = 8;     // enough to tell pictures apart
        settings_.cascade_size = settings_.ceiling_size = 256;
        settings_.shadows = false, settings_.shafts = "off"; // the sun's shadows have pipelines with the scene's layout
    }
    void stand(Renderer& by) const { by.set_scene(&scene_, stand_.placement, stand_.planet.radius); }
    ByteImage drawn(Renderer& by, Settings const& settings) const {
        by.draw(world_, settings, EXTENT);
        return by.picture();
    }

    Stand const stand_ = stand_on(load_planet("earth"));
    World const world_ = stand_.view(stand_.camera({0, 6, 12}, {0, 8, -10}, 1), sun_at(12, 70));
    Scene scene_ = scene_of({matte({0.3f, 0.25f, 0.2f})});
    Settings settings_ = plain_settings();
};

} // namespace

TEST_F(SwitchesInFlight, no_frame_makes_pipelines_and_the_picture_becomes_that_of_the_new_settings) {
    Renderer flying(device(), 2, Switches::when_ready);
    Renderer& at_once = renderer();
    stand(flying), stand(at_once);
    ByteImage before = drawn(flying, settings_);
    drawn(at_once, settings_);
    EXPECT_GT(flying.pipelines_missed(), 0u) << "the first frame";
    for (auto const& [name, value] :
         {std::pair{"shadows", "on"}, {"post_aa", "fxaa"}, {"auto_exposure", "on"}, {"curve", "agx"}}) {
        std::size_t const missed = flying.pipelines_missed(), missed_at_once = at_once.pipelines_missed();
        set_setting(settings_, name, value);
        ByteImage const expected = drawn(at_once, settings_);
        EXPECT_GT(at_once.pipelines_missed(), missed_at_once) << name << " needs none: choose another switch";
        ByteImage now = drawn(flying, settings_);
        for (; !flying.settings_shown(); now = drawn(flying, settings_)) EXPECT_EQ(difference(now, before), 0) << name;
        EXPECT_LE(difference(now, expected), 1) << name;
        EXPECT_GT(difference(now, before), 1) << name;
        EXPECT_EQ(flying.pipelines_missed(), missed) << name;
        before = now;
    }
    // With time enough those of the next switch are made ahead.
    while (!flying.switches_prepared()) std::this_thread::yield();
    std::size_t const missed = flying.pipelines_missed(), missed_at_once = at_once.pipelines_missed();
    settings_.model = "tables";
    ByteImage const expected = drawn(at_once, settings_), now = drawn(flying, settings_);
    EXPECT_TRUE(flying.settings_shown());
    EXPECT_LE(difference(now, expected), 1);
    EXPECT_EQ(flying.pipelines_missed(), missed);
    EXPECT_GT(at_once.pipelines_missed(), missed_at_once + 3) << "tables and all that reads them";
}

TEST_F(SwitchesInFlight, the_scene_and_the_renderer_may_go_while_pipelines_are_made) {
    for (bool const replaced : {true, false}) {
        Renderer flying(device(), 2, Switches::when_ready);
        stand(flying);
        drawn(flying, settings_);
        Settings shaded = settings_;
        shaded.shadows = true;
        flying.draw(world_, shaded, EXTENT);
        if (!replaced) continue;
        stand(flying);
        drawn(flying, shaded);
        EXPECT_TRUE(flying.settings_shown()) << "a new scene is shown at once";
    }
}
