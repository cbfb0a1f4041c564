#include "scene/planet.h"
#include "scene/spectrum.h"
#include "support/files.h"

#include <cmath>
#include <nlohmann/json.hpp>

using namespace alpenglow;
using test::expect_error;

namespace {

void expect_same(AirComponent const& a, AirComponent const& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.scattering, b.scattering);
    EXPECT_EQ(a.absorption, b.absorption);
    EXPECT_EQ(a.phase, b.phase);
    EXPECT_EQ(a.profile, b.profile);
}

nlohmann::json table(nlohmann::json const& nodes) { return {{"kind", "table"}, {"nodes", nodes}}; }

/// As many pieces: between nodes, and a step at the last.
nlohmann::json zigzag(int pieces) {
    nlohmann::json nodes = nlohmann::json::array();
    for (int i = 0; i < pieces; ++i) nodes.push_back({1000 * i, i % 2});
    return nodes;
}

Planet stored(std::string const& name) { return load_planet(test::assets() / "planets" / (name + ".json")); }

/// Earth's file with one value replaced (or removed, by a null), read back.
void load_changed(std::string const& pointer, nlohmann::json const& value) {
    nlohmann::json file = nlohmann::json::parse(read_text_file(test::assets() / "planets/earth.json"));
    nlohmann::json::json_pointer const at(pointer);
    if (value.is_null()) file[at.parent_pointer()].erase(at.back());
    else file[at] = value;
    test::TemporaryFolder const folder;
    load_planet(folder.write("bad.json", file.dump()));
}

} // namespace

TEST(PlanetFiles, earth_is_the_built_in_one) {
    Planet const file = stored("earth"), built_in = make_earth();
    EXPECT_EQ(file.name, built_in.name);
    EXPECT_EQ(file.radius, built_in.radius);
    EXPECT_TRUE(file.has_air && built_in.has_air);
    EXPECT_EQ(file.air.top_altitude, built_in.air.top_altitude);
    ASSERT_EQ(file.air.components.size(), built_in.air.components.size());
    for (std::size_t i = 0; i < built_in.air.components.size(); ++i)
        expect_same(file.air.components[i], built_in.air.components[i]);
    EXPECT_EQ(file.look, built_in.look);
    EXPECT_EQ(file.ground_albedo, built_in.ground_albedo);
    EXPECT_EQ(file.solar_irradiance, built_in.solar_irradiance);
    EXPECT_NEAR(file.sun_angular_radius, built_in.sun_angular_radius, 1e-16); // through degrees
}

TEST(PlanetFiles, earth_has_300_dobson_units_and_the_canonical_coefficients) {
    Air const air = make_earth().air;
    AirComponent const& ozone = air.at("ozone");
    // Zenith optical depth of a tent: peak times half its base.
    glm::dvec3 const depth = ozone.absorption * profile_column(ozone.profile, air.top_altitude);
    glm::dvec3 const rayleigh{5.802e-6, 13.558e-6, 33.100e-6}, absorbed{0.650e-6, 1.881e-6, 0.085e-6};
    glm::dvec3 const published_depth{0.00975, 0.02822, 0.00128};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(depth[i], published_depth[i], 5.1e-6 + 1e-3 * published_depth[i]); // as rounded there
        EXPECT_NEAR(air.at("rayleigh").scattering[i], rayleigh[i], 1e-3 * rayleigh[i]);
        EXPECT_NEAR(ozone.absorption[i], absorbed[i], 1e-3 * absorbed[i]);
    }
    AirComponent const& aerosol = air.at("aerosol");
    EXPECT_NEAR(aerosol.scattering.x / aerosol.extinction().x, 0.9, 1e-12);
}

TEST(PlanetFiles, ozones_column_is_300_dobson_units_however_it_is_spread) {
    for (char const* const name : {"earth", "earth_hazy", "dense", "earth_exponential_ozone"}) {
        Air const air = stored(name).air;
        AirComponent const& ozone = air.at("ozone");
        double const molecules = ozone.absorption.y / ozone_cross_section(550e-9); // [1/m^3]
        EXPECT_NEAR(molecules * profile_column(ozone.profile, air.top_altitude) / DOBSON_UNIT, 300, 1e-9) << name;
    }
    // The share that the exponential one's document prints, 6e-7 of the air's 2.545e25 molecules, is half as much again.
    EXPECT_NEAR(6e-7 * 2.545e25 * 8000 / DOBSON_UNIT, 454, 1);
    EXPECT_EQ(stored("earth_no_ozone").air.components.size(), 2u);
}

TEST(PlanetFiles, the_other_presets) {
    Planet const hazy = stored("earth_hazy");
    AirComponent const& haze = hazy.air.at("aerosol");
    EXPECT_EQ(haze.phase.g, 0.76);
    EXPECT_NEAR(haze.scattering.y / haze.extinction().y, 0.9, 1e-12);
    expect_same(hazy.air.at("rayleigh"), make_earth().air.at("rayleigh"));
    Planet const dense = stored("dense");
    AirComponent const &molecules = dense.air.at("rayleigh"), &dust = dense.air.at("aerosol");
    EXPECT_NEAR(molecules.scattering.x, 0.149 / 1000, 1e-15); // the document has 1/km
    glm::dvec3 const dust_extinction(0.082e-3, 0.071e-3, 0.058e-3);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(dust.extinction()[i], dust_extinction[i], 1e-15);
    EXPECT_LT(std::exp(-dense.air.top_altitude / 18416), 1e-4) << "the top cuts the air off";
    Planet const airless = stored("airless");
    EXPECT_FALSE(airless.has_air);
    EXPECT_EQ(airless.look, GroundLook::uniform);
    EXPECT_EQ(airless.radius, make_earth().radius);
}

TEST(PlanetFiles, are_found_by_name) {
    ::setenv("ALPENGLOW_ASSETS", test::assets().c_str(), 1);
    EXPECT_EQ(load_planet("dense").name, "dense");
    expect_error(ErrorKind::bad_input, {"planet pluto", "no planet of this name"}, [] { load_planet("pluto"); });
    expect_error(ErrorKind::bad_input, {"no planet of this name"}, [] { load_planet(std::string(500, 'a')); });
    ::unsetenv("ALPENGLOW_ASSETS");
}

TEST(PlanetFiles, bad_ones_are_refused_with_the_place_and_the_reason) {
    using Json = nlohmann::json;
    struct Case { std::string pointer; Json value; std::vector<std::string> parts; };
    std::vector<Case> const cases{
        {"/radius", 0, {"bad.json at /radius", "0 is out of range", "reference radius", "at least 1000"}},
        {"/radius", -6.36e6, {"/radius", "out of range"}},
        {"/radius", 1e30, {"/radius", "out of range"}},
        {"/radius", "6360 km", {"/radius", "\"6360 km\" is not a number"}},
        {"/radius", nullptr, {"bad.json: has no \"radius\""}},
        {"/radious", 1, {"unknown key \"radious\"", "did you mean radius?"}},
        {"/air/components/0/profile/scale_height", 0, {"/air/components/0/profile/scale_height", "out of range"}},
        {"/air/components/0/profile/kind", "box", {"/profile/kind", "\"box\"", "exponential, tent, shell, table"}},
        {"/air/components/0/profile/centre", 5, {"/air/components/0/profile", "unknown key \"centre\""}},
        {"/air/components/0/profile", nullptr, {"/air/components/0: has no \"profile\""}},
        {"/air/components/0/name", "aerosol", {"/air/components/1/name", "two components \"aerosol\""}},
        {"/air/components/0/name", "a,b", {"/air/components/0/name", "no name for a component"}},
        {"/air/components/0/name", "", {"/air/components/0/name", "no name for a component"}},
        {"/air/components/0/extinction", 1, {"/air/components/0", "unknown key \"extinction\""}},
        {"/air/components/0/scattering", Json{{"air_density", -1}}, {"/scattering/air_density", "out of range"}},
        {"/air/components/0/scattering", Json{{"water", 1}}, {"/components/0/scattering", "unknown key \"water\""}},
        {"/air/components/0/phase", nullptr, {"/air/components/0: has no \"phase\""}},
        {"/air/components/0/phase/kind", "mie", {"/components/0/phase/kind", "no phase \"mie\"", "cornette_shanks"}},
        {"/air/components/0/phase/g", 0.5, {"/air/components/0/phase", "unknown key \"g\""}},
        {"/air/components/1/phase/g", 1, {"/air/components/1/phase/g", "out of range"}},
        {"/air/components/1/phase", Json{{"kind", "droplets"}, {"diameter", 10}}, {"/phase/diameter", "out of range"}},
        {"/air/components/1/scattering", Json::array({-1e-6, 0, 0}), {"/components/1/scattering/0", "out of range"}},
        {"/air/components/1/scattering", Json::array({0, 0}), {"/air/components/1/scattering", "three numbers"}},
        {"/air/components/1/scattering", 1e-6, {"/air/components/1/scattering", "three numbers"}},
        {"/air/components/1/scattering", nullptr, {"/air/components/1/phase", "a phase is for what scatters"}},
        {"/air/components/2/profile/half_width", 0, {"/air/components/2/profile/half_width", "out of range"}},
        {"/air/components/2/profile/centre", 1e7, {"/air/components/2/absorption", "the profile is empty"}},
        {"/air/components/2/profile", Json{{"kind", "shell"}, {"bottom", 9}, {"top", 9}}, {"/profile/top", "not above"}},
        {"/air/components/2/profile", table(Json::array({{0, 1}})), {"/profile/nodes", "two nodes at least"}},
        {"/air/components/2/profile", table(Json::array({{0, 1}, {5, 1, 2}})), {"/profile/nodes/1", "two numbers"}},
        {"/air/components/2/profile", table(Json::array({{5, 1}, {4, 1}})), {"/nodes/1/0", "below the one before"}},
        {"/air/components/2/profile", table(Json::array({{0, -1}, {5, 1}})), {"/nodes/0/1", "out of range"}},
        {"/air/components/2/profile", table(zigzag(26)), {"/air/components", "26 pieces", "room for 24"}},
        {"/air/components", Json::array(), {"/air/components", "the air has 0 components", "1 to 8"}},
        {"/air/wavelengths", Json::array({1, 1, 1}), {"/air/wavelengths/0", "a wavelength in metres"}},
        {"/air/top_altitude", false, {"/air/top_altitude", "false is not a number"}},
        {"/air", 7, {"at /air", "7 is not an object"}},
        {"/air", Json::array(), {"at /air", "a list is not an object"}},
        {"/ground/look", "stripes", {"/ground/look", "stripes", "uniform or procedural"}},
        {"/ground/albedo", Json::array({0.1, 1.1, 0.1}), {"/ground/albedo/1", "out of range"}},
        {"/sun/angular_radius", 0, {"/sun/angular_radius", "more than 0"}},
        {"/sun", nullptr, {"has no \"sun\""}},
        {"/source", nullptr, {"has no \"source\""}},
    };
    for (Case const& c : cases) expect_error(ErrorKind::bad_input, c.parts, [&] { load_changed(c.pointer, c.value); });
}
