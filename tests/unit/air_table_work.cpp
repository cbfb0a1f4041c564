#include "render/air_table_store.h"
#include "render/atmosphere_constants.h"
#include "render/models/models.h"
#include "scene/planet.h"

#include <gtest/gtest.h>

#include <functional>

using namespace alpenglow;

namespace {

struct AirChange {
    char const* name;
    std::function<void(Planet&)> change;
};

std::vector<AirChange> const CHANGES{
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

/// Finished tables of that planet, as far as the store keeps its books.
AirTableStore::Kept finished_tables(AirModel const& model, Planet const& planet) {
    AirTableStore::Kept kept{model};
    kept.made_for = atmosphere_of(planet);
    kept.planet = planet.name;
    kept.progress = {model.steps(*kept.made_for).size(), 0};
    return kept;
}

} // namespace

TEST(AirTableWork, begins_anew_with_every_change_of_the_air_and_only_then) {
    Planet const earth = make_earth();
    for (AirModel const& model : air_models()) {
        AirTableStore::Kept const kept = finished_tables(model, earth);
        EXPECT_TRUE(table_work(kept, atmosphere_of(earth), false, {}).slices.empty());
        for (auto const& [name, change] : CHANGES) {
            Planet changed = earth;
            change(changed);
            TableWork const work = table_work(kept, atmosphere_of(changed), false, {});
            EXPECT_EQ(work.slices, remaining_slices(model.steps(atmosphere_of(changed)), {})) << model.name << ", " << name;
        }
    }
}

TEST(AirTableWork, tables_may_be_read_when_they_have_been_finished_for_the_planet) {
    AirModel const& model = air_model("tables");
    Planet const earth = make_earth();
    Planet hazy = earth;
    hazy.air.at("aerosol").scattering *= 2.0;
    AirTableStore::Kept kept{model};
    kept.tables.resize(model.tables.size());
    auto const work = [&](Planet const& planet, std::string const& name, bool spread) {
        shader::Atmosphere const air = atmosphere_of(planet);
        finish_work(kept, air, name, table_work(kept, air, spread, {}));
        return kept.finished_for(air);
    };
    EXPECT_FALSE(work(earth, "earth", true));
    EXPECT_EQ(kept.planet, "") << "one group is made";
    EXPECT_TRUE(work(earth, "earth", false));
    EXPECT_EQ(kept.planet, "earth");
    EXPECT_FALSE(work(hazy, "earth", true));
    EXPECT_EQ(kept.planet, "earth") << "they are whole, for the air before";
    EXPECT_FALSE(kept.finished_for(atmosphere_of(earth)));
    EXPECT_FALSE(work(earth, "hazy", true));
    EXPECT_EQ(kept.planet, "") << "of two planets";
}
