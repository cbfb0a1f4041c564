#include "render/air_table_schedule.h"
#include "render/models/models.h"
#include "support/render_test.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{160, 90}; // a frame dear enough that tables are done in a few hundred

class SpreadTables : public RenderTest, public ::testing::WithParamInterface<char const*> {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        settings_.model = GetParam();
        settings_.spread_tables = true;
    }
    void draw() {
        renderer().draw(world_, settings_, EXTENT);
        renderer().wait();
    }
    std::vector<AirTableStep> const& steps() const { return air_model(GetParam()).steps; }
    /// The table whose states are looked at, and which is whole when the test has seen enough: of `tables` the last, and of
    /// `march` the coarse one, for whose steps a fifth of the work is done. Long tests go on to march's last.
    std::string watched() const {
        bool const whole = GetParam() == std::string_view("tables") || std::getenv("ALPENGLOW_LONG_TESTS");
        return whole ? air_model(GetParam()).tables.back().name : "coarse_orders";
    }
    bool makes_watched(AirTableStep const& step) const { return air_model(GetParam()).tables[step.makes.table].name == watched(); }
    std::string bytes(std::string const& table) const {
        std::vector<std::byte> const bytes = renderer().image_bytes(table);
        return {reinterpret_cast<char const*>(bytes.data()), bytes.size()};
    }
    std::vector<std::string> all_tables() const {
        std::vector<std::string> all;
        for (AirTable const& table : air_model(GetParam()).tables) all.push_back(bytes(table.name));
        return all;
    }
    /// Workgroups of the tables' passes in the last frame.
    std::map<std::string, std::uint64_t> groups_made() const {
        std::map<std::string, std::uint64_t> groups;
        for (PassTime const& time : renderer().timings()) {
            if (std::ranges::find(steps(), time.name, &AirTableStep::pass) != steps().end())
                groups[time.name] = time.groups;
        }
        return groups;
    }

    Stand stand_ = stand_on(load_planet("earth"));
    World world_ = stand_.view(stand_.camera({0, 10, 0}, {0, 12, -1}, 1), sun_at(20, 30));
    Settings settings_ = plain_settings();
};

} // namespace

TEST_P(SpreadTables, keep_every_frame_to_its_share_and_end_as_those_made_at_once) {
    world_.planet.air.at("aerosol").phase.g = 0.7;
    TablePace pace;
    pace.note(renderer().timings(), steps());
    std::set<std::string> seen; // states of the table that the picture is lit by, as bytes
    std::string const shown = air_model(GetParam()).tables.back().name;
    int frames = 0;
    for (bool finished = false; !finished && frames < 20000; ++frames) {
        draw();
        finished = renderer().tables_finished();
        if (frames > 10) { // costs of passes that this test has not seen are known to the renderer
            double made = 0, most = 0;
            for (auto const& [pass, groups] : groups_made()) {
                double const each = pace.group_ms(pass).value_or(0);
                made += each * double(groups), most = std::max(most, each);
            }
            EXPECT_LE(made, std::max(TABLES_SHARE * pace.frame_ms() * 1.0001, most)) << "frame " << frames;
        }
        pace.note(renderer().timings(), steps());
        std::vector<std::byte> const bytes = renderer().image_bytes(shown);
        seen.emplace(reinterpret_cast<char const*>(bytes.data()), bytes.size());
    }
    EXPECT_GT(frames, 5);
    auto const makes_shown = [&](AirTableStep const& step) { return air_model(GetParam()).tables[step.makes.table].name == shown; };
    // What a frame reads is a step's whole table: there are no other states.
    EXPECT_LE(seen.size(), 1 + std::size_t(std::ranges::count_if(steps(), makes_shown)));

    Renderer fresh(device());
    settings_.spread_tables = false;
    fresh.draw(world_, settings_, EXTENT);
    for (AirTable const& table : air_model(GetParam()).tables)
        EXPECT_TRUE(renderer().image_bytes(table.name) == fresh.image_bytes(table.name)) << table.name;
}

TEST_P(SpreadTables, are_made_at_once_for_another_planet_and_for_a_picture) {
    world_.planet = load_planet("earth_hazy");
    draw();
    EXPECT_TRUE(renderer().tables_finished());
    world_.planet.air.at("aerosol").phase.g = 0.7;
    draw();
    EXPECT_FALSE(renderer().tables_finished());
    settings_.spread_tables = false;
    draw();
    EXPECT_TRUE(renderer().tables_finished());
    draw();
    EXPECT_TRUE(groups_made().empty());
}

INSTANTIATE_TEST_SUITE_P(Models, SpreadTables, ::testing::Values("march", "tables"),
                         [](auto const& given) { return std::string(given.param); });
