#include "scene/air_changes.h"
#include "scene/view.h"
#include "support/components.h"
#include "support/files.h"

using namespace alpenglow;
using test::expect_error;

TEST(AirChanges, switch_components_off) {
    Air const air = changed_air(make_earth().air, "ozone,aerosol", "");
    EXPECT_TRUE(air.at("rayleigh").on);
    EXPECT_FALSE(air.at("ozone").on || air.at("aerosol").on);
    EXPECT_TRUE(changed_air(make_earth().air, "", "").at("ozone").on);
}

TEST(AirChanges, give_other_phases) {
    Air const air =
        changed_air(make_earth().air, "", "aerosol=droplets:2e-05,rayleigh=double_henyey_greenstein:0.5:-0.25:0.1");
    EXPECT_EQ(air.at("aerosol").phase.kind, Phase::Kind::droplets);
    EXPECT_EQ(air.at("aerosol").phase.diameter, 2e-5);
    EXPECT_EQ(air.at("rayleigh").phase, (Phase{Phase::Kind::double_henyey_greenstein, 0.5, -0.25, 0.1}));
}

TEST(AirChanges, are_read_back_from_what_they_are_written_as) {
    Air const planet = test::motley_planet().air;
    Air changed = planet;
    changed.at("mist").on = changed.at("ozone").on = false;
    changed.at("dust").phase = {.kind = Phase::Kind::cornette_shanks, .g = 0.1};
    changed.at("shell").phase = {.kind = Phase::Kind::isotropic};
    EXPECT_EQ(names_switched_off(changed), "mist,ozone");
    EXPECT_EQ(phases_beside(planet, changed), "shell=isotropic,dust=cornette_shanks:0.1");
    Air const read = changed_air(planet, names_switched_off(changed), phases_beside(planet, changed));
    for (std::size_t i = 0; i < planet.components.size(); ++i) {
        EXPECT_EQ(read.components[i].on, changed.components[i].on);
        EXPECT_EQ(phase_text(read.components[i].phase), phase_text(changed.components[i].phase));
    }
    EXPECT_EQ(names_switched_off(planet) + phases_beside(planet, planet), "");
}

TEST(AirChanges, reach_the_world) {
    View view;
    view.camera.place.altitude = 100;
    view.settings.air_without = "ozone";
    EXPECT_FALSE(make_world(view, make_earth()).planet.air.at("ozone").on);
}

TEST(AirChanges, bad_ones_are_refused) {
    struct Case {
        std::string without, phases;
        std::vector<std::string> parts;
    };
    std::vector<Case> const cases{
        {"ozon", "", {"setting air_without", "no component \"ozon\"", "did you mean ozone?"}},
        {"x", "", {"it has rayleigh, aerosol, ozone"}},
        {"", "aerosol", {"setting air_phases", "has no ="}},
        {"", "dust=isotropic", {"no component \"dust\""}},
        {"", "aerosol=mie", {"no phase \"mie\"", "cornette_shanks"}},
        {"", "aerosol=", {"no phase"}},
        {"", "aerosol=cornette_shanks", {"has 0 numbers", "has 1"}},
        {"", "aerosol=rayleigh:0.5", {"has 1 numbers", "has 0"}},
        {"", "aerosol=henyey_greenstein:1", {"\"1\" is no g", "-0.99 to 0.99"}},
        {"", "aerosol=henyey_greenstein:nan", {"\"nan\" is no g"}},
        {"", "aerosol=droplets:20", {"\"20\" is no diameter"}},
    };
    for (Case const& c : cases)
        expect_error(ErrorKind::bad_input, c.parts, [&] { changed_air(make_earth().air, c.without, c.phases); });
    expect_error(ErrorKind::bad_input, {"it has none"}, [] { changed_air(Air{}, "ozone", ""); });
}
