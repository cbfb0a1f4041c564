#include "support/render_test.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{48, 27};

/// Another value of a setting, in its range; of a text that takes any, one that is known here.
std::optional<SettingValue> another_value(Settings const& settings, SettingInfo const& info) {
    SettingValue const now = get_setting(settings, info);
    std::vector<std::string> choices = choices_of(info);
    std::erase(choices, setting_text(settings, info));
    if (bool const* const on = std::get_if<bool>(&now)) return !*on;
    if (!choices.empty() && std::holds_alternative<std::string>(now)) return choices.front();
    if (!choices.empty()) return std::stoi(choices.front());
    if (info.name == "show") return "lit";
    if (info.name == "air_without") return "ozone";
    if (info.name == "air_phases") return "aerosol=henyey_greenstein:0.6";
    if (int const* const whole = std::get_if<int>(&now)) return std::max(int(info.smallest), *whole / 2);
    if (double const* const number = std::get_if<double>(&now))
        return std::clamp(*number == 0 ? 1 : *number / 2, info.smallest, info.largest);
    return std::nullopt;
}

struct AirChange {
    char const* name;
    std::function<void(Planet&)> change;
};

std::vector<AirChange> const AIR_CHANGES{
    {"rayleigh scattering", [](Planet& planet) { planet.air.at("rayleigh").scattering *= 1.5; }},
    {"rayleigh scale height", [](Planet& planet) { planet.air.at("rayleigh").profile = ExponentialProfile{6400}; }},
    {"aerosol scattering", [](Planet& planet) { planet.air.at("aerosol").scattering *= 0.5; }},
    {"aerosol absorption", [](Planet& planet) { planet.air.at("aerosol").absorption *= 30.0; }},
    {"aerosol scale height", [](Planet& planet) { planet.air.at("aerosol").profile = ExponentialProfile{1800}; }},
    {"aerosol g", [](Planet& planet) { planet.air.at("aerosol").phase.g = 0.6; }},
    {"ozone", [](Planet& planet) { planet.air.at("ozone").absorption *= 0.0; }},
    {"ozone switched off", [](Planet& planet) { planet.air.at("ozone").on = false; }},
    {"aerosol in a shell", [](Planet& planet) { planet.air.at("aerosol").profile = shell_profile(1000, 3000); }},
    {"one component less", [](Planet& planet) { planet.air.components.pop_back(); }},
    {"top", [](Planet& planet) { planet.air.top_altitude = 7e4; }},
    {"albedo", [](Planet& planet) { planet.ground_albedo = glm::dvec3(0.6); }},
    {"sunlight", [](Planet& planet) { planet.solar_irradiance = {1.5, 1.2, 0.9}; }},
    {"radius", [](Planet& planet) { planet.radius *= 0.5; }},
};

/// A renderer that has drawn something else before draws as one that has not.
class Changes : public RenderTest {
protected:
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
        if (placed_on_ != &by || radius_ != planet.radius) {
            by.set_scene(&scene_, stand_on(planet).placement, planet.radius);
            placed_on_ = &by, radius_ = planet.radius;
        }
        do by.draw(world_of(planet), settings, EXTENT);
        while (!by.tables_finished());
        return by.picture();
    }
    void expect_fresh(Planet const& planet, Settings const& settings, std::string_view what) {
        ByteImage const changed = drawn(running_, planet, settings);
        Renderer fresh(device());
        ByteImage const expected = drawn(fresh, planet, settings);
        int most = 0;
        for (std::size_t i = 0; i < expected.rgba.size(); ++i)
            most = std::max(most, std::abs(int(changed.rgba[i]) - int(expected.rgba[i])));
        EXPECT_LE(most, 1) << what;
    }

    Planet const earth_ = load_planet("earth");
    Scene scene_ = scene_of({matte({0.3f, 0.25f, 0.2f})});
    Renderer running_{device()};
    Renderer const* placed_on_ = nullptr;
    double radius_ = 0;
};

} // namespace

TEST_F(Changes, of_each_setting_give_the_picture_of_a_fresh_start) {
    Settings base;
    base.model = "naive"; // it has no tables to make for each fresh start
    base.cascade_size = 256;
    for (SettingInfo const& info : setting_table()) {
        std::optional<SettingValue> const value = another_value(base, info);
        if (!value) {
            ADD_FAILURE() << "give setting " << info.name << " another value here";
            continue;
        }
        Settings settings = base;
        set_setting(settings, info, *value);
        drawn(running_, earth_, base);
        expect_fresh(earth_, settings, info.name);
    }
}

TEST_F(Changes, of_what_the_default_model_obeys_give_the_picture_of_a_fresh_start) {
    Settings base;
    base.cascade_size = 256;
    for (char const* const name : {"air", "model", "samples", "shafts", "multiple_scattering", "march_dither", "shadows"}) {
        Settings settings = base;
        SettingInfo const& info = *find_setting(name);
        set_setting(settings, info, *another_value(base, info));
        drawn(running_, earth_, base);
        expect_fresh(earth_, settings, name);
    }
}

TEST_F(Changes, of_the_air_give_the_picture_of_a_fresh_start) {
    Settings settings;
    settings.model = "tables";
    settings.cascade_size = 256;
    drawn(running_, earth_, settings);
    for (AirChange const& change : AIR_CHANGES) {
        Planet planet = earth_;
        change.change(planet);
        settings.model = change.name == std::string_view("aerosol g") ? "march" : "tables";
        expect_fresh(planet, settings, change.name);
    }
}

TEST_F(Changes, of_the_planet_give_the_picture_of_a_fresh_start) {
    Settings settings;
    settings.model = "tables";
    settings.spread_tables = true;
    settings.cascade_size = 256;
    drawn(running_, earth_, settings);
    for (char const* const name : {"dense", "airless", "earth_hazy"}) expect_fresh(load_planet(name), settings, name);
}
