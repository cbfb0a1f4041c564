#include "support/render_test.h"

#include <algorithm>
#include <map>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{32, 18};

/// Another value of a setting, in its range; of a text that takes any, one that is known here.
std::optional<SettingValue> another_value(Settings const& settings, SettingInfo const& info) {
    SettingValue const now = get_setting(settings, info);
    std::vector<std::string> choices = choices_of(info);
    std::erase(choices, setting_text(settings, info));
    if (bool const* const on = std::get_if<bool>(&now)) return !*on;
    if (!choices.empty() && std::holds_alternative<std::string>(now)) return choices.back();
    if (!choices.empty()) return std::stoi(choices.front());
    if (info.name == "show") return "lit";
    if (info.name == "air_without") return "ozone";
    if (info.name == "air_phases") return "aerosol=henyey_greenstein:0.6";
    if (int const* const whole = std::get_if<int>(&now)) return *whole / 2 < info.smallest ? *whole * 2 : *whole / 2;
    if (double const* const number = std::get_if<double>(&now))
        return std::clamp(*number == 0 ? 1 : *number / 2, info.smallest, info.largest);
    return std::nullopt;
}

/// A renderer that has drawn something else before draws as one that has not.
class Changes : public RenderTest {
protected:
    static void SetUpTestSuite() { other_ = std::make_unique<Renderer>(device()); }
    static void TearDownTestSuite() { other_.reset(); }
    void SetUp() override {
        RenderTest::SetUp();
        add_plane(scene_, 40, 1);
        add_box(scene_, {-6, 4, -12}, {3, 3, 3});
    }
    World world_of(Planet const& planet) const {
        Stand const stand = stand_on(planet);
        return stand.view(stand.camera({0, 6, 12}, {0, 8, -10}, glm::radians(60.0)), sun_at(12, 70));
    }
    /// With tables that are finished.
    ByteImage drawn(Renderer& by, Planet const& planet, Settings const& settings) {
        double& radius = placed_on_[&by];
        if (radius != planet.radius) by.set_scene(&scene_, stand_on(planet).placement, radius = planet.radius);
        do by.draw(world_of(planet), settings, EXTENT);
        while (!by.tables_finished());
        return by.picture();
    }
    /// Two renderers with different pasts: one has drawn `base`, the other one with all of `changes` made. A setting that
    /// either of them does not obey at once makes a difference.
    void expect_obeyed(Settings const& base, std::vector<SettingInfo const*> const& changes) {
        Settings all = base;
        for (SettingInfo const* const info : changes) set_setting(all, *info, *another_value(base, *info));
        for (SettingInfo const* const info : changes) {
            Settings settings = base;
            set_setting(settings, *info, *another_value(base, *info));
            drawn(renderer(), earth_, base);
            drawn(*other_, earth_, all);
            ByteImage const changed = drawn(renderer(), earth_, settings);
            expect_same(changed, drawn(*other_, earth_, settings), info->name);
        }
    }
    void expect_fresh(Planet const& planet, Settings const& settings, std::string_view what) {
        ByteImage const changed = drawn(renderer(), planet, settings);
        Renderer fresh(device());
        placed_on_.erase(&fresh);
        expect_same(changed, drawn(fresh, planet, settings), what);
    }
    static void expect_same(ByteImage const& changed, ByteImage const& expected, std::string_view what) {
        EXPECT_LE(difference(changed, expected), 1) << what;
    }

    Planet const earth_ = load_planet("earth");
    Scene scene_ = scene_of({matte({0.3f, 0.25f, 0.2f})});
    std::map<Renderer const*, double> placed_on_; ///< radius of the planet on which its scene stands [m]

    static inline std::unique_ptr<Renderer> other_;
};

} // namespace

TEST_F(Changes, of_each_setting_are_obeyed_at_once) {
    Settings base;
    base.model = "naive"; // it has no tables to make for each air
    base.samples = 8;     // enough to tell pictures apart
    base.cascade_size = base.ceiling_size = 256;
    std::vector<SettingInfo const*> changes;
    for (SettingInfo const& info : setting_table()) {
        if (another_value(base, info)) {
            changes.push_back(&info);
        } else {
            ADD_FAILURE() << "give setting " << info.name << " another value here";
        }
    }
    expect_obeyed(base, changes);
}

TEST_F(Changes, of_what_the_default_model_obeys_are_obeyed_at_once) {
    Settings base;
    base.cascade_size = base.ceiling_size = 256;
    base.samples = 8; // half of them is seen
    std::vector<SettingInfo const*> changes;
    for (char const* const name : {"air", "model", "samples", "shafts", "multiple_scattering", "march_dither", "shadows"})
        changes.push_back(find_setting(name));
    expect_obeyed(base, changes);
}

// Which changes of the air have the tables made anew is in tests/unit/air_table_work.cpp.
TEST_F(Changes, of_the_air_and_the_planet_give_the_picture_of_a_fresh_start) {
    Settings settings;
    settings.model = "tables";
    settings.cascade_size = settings.ceiling_size = 256;
    drawn(renderer(), earth_, settings);
    Planet changed = earth_;
    changed.air.at("aerosol").profile = shell_profile(1000, 3000);
    changed.air.components.pop_back();
    changed.ground_albedo = glm::dvec3(0.6);
    expect_fresh(changed, settings, "another air");
    settings.spread_tables = true;
    for (char const* const name : {"dense", "airless", "earth_hazy"}) expect_fresh(load_planet(name), settings, name);
}
