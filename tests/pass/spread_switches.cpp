#include "render/models/models.h"
#include "support/render_test.h"

#include <map>
#include <thread>

using namespace alpenglow;
using namespace alpenglow::test;
using namespace std::chrono_literals;

namespace {

constexpr Extent EXTENT{34, 18};

/// A renderer as a window has it, over a bare planet, and one that makes everything at once.
class SpreadSwitches : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        settings_.samples = 8; // enough to tell pictures apart
        settings_.spread_tables = true;
        settings_.model = "naive"; // no tables
        draw();
        missed_ = flying_.pipelines_missed();
    }
    /// Until its tables are begun: pipelines come first.
    void switch_to_tables() {
        settings_.model = "tables";
        do draw();
        while (groups_made().empty());
        EXPECT_FALSE(flying_.settings_shown());
    }
    ByteImage draw() {
        flying_.draw(world_, settings_, EXTENT);
        return flying_.picture();
    }
    ByteImage drawn_at_once(std::string const& model) {
        Settings settings = settings_;
        settings.model = model;
        at_once_.draw(world_, settings, EXTENT);
        return at_once_.picture();
    }
    /// Workgroups of the passes that make tables, in the last frame.
    std::map<std::string, std::uint64_t> groups_made() const {
        std::map<std::string, std::uint64_t> groups;
        for (PassTime const& time : flying_.timings()) {
            if (table_passes().contains(time.name)) groups[time.name] = time.groups;
        }
        return groups;
    }

    Stand const stand_ = stand_on(load_planet("earth"));
    World const world_ = stand_.view(stand_.camera({0, 10, 0}, {0, 12, -1}, 1), sun_at(20, 30));
    Settings settings_ = plain_settings();
    std::size_t missed_ = 0; ///< pipelines, by its first frame
    Renderer flying_{device(), 2, Switches::when_ready}, at_once_{device()};
};

} // namespace

TEST_F(SpreadSwitches, make_each_workgroup_once_over_frames_that_show_all_but_the_model) {
    ByteImage const expected = drawn_at_once("tables");
    ASSERT_GT(difference(drawn_at_once("naive"), expected), 1);
    switch_to_tables();
    std::map<std::string, std::uint64_t> made = groups_made();
    settings_.exposure += 1;
    ByteImage const waiting = drawn_at_once("naive");
    int frames = 1;
    for (ByteImage now = draw(); !flying_.settings_shown() && frames < 5000; now = draw(), ++frames) {
        EXPECT_LE(difference(now, waiting), 1) << "frame " << frames;
        for (auto const& [pass, groups] : groups_made()) made[pass] += groups;
    }
    EXPECT_LE(difference(flying_.picture(), drawn_at_once("tables")), 1);
    std::vector<AirTableStep> const& steps = air_model("tables").steps({});
    EXPECT_GE(frames, 2 * int(steps.size())) << "of a pass of unknown cost, one group runs by itself";
    for (AirTableStep const& step : steps) EXPECT_EQ(made[step.pass], step.groups) << step.pass;
    EXPECT_EQ(flying_.pipelines_missed(), missed_);
    for (AirTable const& table : air_model("tables").tables)
        EXPECT_TRUE(flying_.image_bytes(table.name) == at_once_.image_bytes(table.name)) << table.name;
}

TEST_F(SpreadSwitches, have_tables_made_ahead_behind_a_picture_that_needs_none) {
    while (!flying_.switches_prepared() || !flying_.switches_rehearsed()) std::this_thread::sleep_for(1ms);
    EXPECT_LE(difference(draw(), drawn_at_once("naive")), 1);
    EXPECT_FALSE(groups_made().empty());
    EXPECT_TRUE(flying_.tables_finished());
    EXPECT_FALSE(flying_.tables_ahead_finished());
    EXPECT_EQ(flying_.pipelines_missed(), missed_);
}
