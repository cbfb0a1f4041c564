#include "render/air_table_schedule.h"
#include "render/atmosphere_constants.h"
#include "render/models/models.h"
#include "support/render_test.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>

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
    std::vector<AirTableStep> const& steps() const { return air_model(GetParam()).steps(atmosphere_of(world_.planet)); }
    /// The table whose states are seen until it is whole. A fifth of the work of `march` does for its coarse orders, which
    /// are made by steps of every kind; long tests go on to its last table.
    std::string watched() const {
        bool const all = GetParam() == std::string_view("tables") || std::getenv("ALPENGLOW_LONG_TESTS");
        return all ? air_model(GetParam()).tables.back().name : "coarse_orders";
    }
    bool makes_watched(AirTableStep const& step) const { return air_model(GetParam()).tables[step.makes.table].name == watched(); }
    /// The step behind the last that makes the watched table has begun in the last frame, or there is no more to do.
    bool watched_is_whole() const {
        auto const last = std::find_if(steps().rbegin(), steps().rend(), [&](AirTableStep const& step) { return makes_watched(step); });
        return renderer().tables_finished() || (last != steps().rbegin() && groups_made().contains(last.base()->pass));
    }
    static std::string bytes(std::string const& table) {
        std::vector<std::byte> const texels = renderer().image_bytes(table);
        return {reinterpret_cast<char const*>(texels.data()), texels.size()};
    }
    std::map<std::string, std::string> all_tables() const {
        std::map<std::string, std::string> all;
        for (AirTable const& table : air_model(GetParam()).tables) all[table.name] = bytes(table.name);
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
    draw();
    EXPECT_TRUE(renderer().tables_finished()) << "never made before";
    std::map<std::string, std::string> const at_once = all_tables();

    Planet const planet = std::exchange(world_.planet, load_planet("earth_hazy"));
    draw();
    EXPECT_TRUE(renderer().tables_finished()) << "of another planet";
    EXPECT_FALSE(all_tables() == at_once);
    draw();

    world_.planet = planet;
    world_.planet.name = "earth_hazy";
    TablePace pace;
    pace.note(renderer().timings(), table_passes());
    std::set<std::string> seen; // states of the table that is watched, as bytes
    int frames = 0;
    do {
        draw();
        if (++frames > 10) { // costs of passes that this test has not seen are known to the renderer
            double made = 0, most = 0;
            for (auto const& [pass, groups] : groups_made()) {
                double const each = pace.group_ms(pass).value_or(0);
                made += each * double(groups), most = std::max(most, each);
            }
            EXPECT_LE(made, std::max(TABLES_SHARE * pace.frame_ms() * 1.0001, most)) << "frame " << frames;
        }
        pace.note(renderer().timings(), table_passes());
        seen.insert(bytes(watched()));
    } while (!watched_is_whole() && frames < 20000);
    EXPECT_GT(frames, 10);
    EXPECT_GT(seen.size(), 1u);
    // What a frame reads is a step's whole table: there are no other states.
    auto const states = std::ranges::count_if(steps(), [&](AirTableStep const& step) { return makes_watched(step); });
    EXPECT_LE(seen.size(), 1 + std::size_t(states));
    EXPECT_TRUE(bytes(watched()) == at_once.at(watched()));

    settings_.spread_tables = false;
    draw();
    EXPECT_TRUE(renderer().tables_finished()) << "for a picture";
    for (auto const& [table, texels] : all_tables()) EXPECT_TRUE(texels == at_once.at(table)) << table;
    draw();
    EXPECT_TRUE(groups_made().empty());
}

INSTANTIATE_TEST_SUITE_P(Models, SpreadTables, ::testing::Values("march", "tables"),
                         [](auto const& given) { return std::string(given.param); });
