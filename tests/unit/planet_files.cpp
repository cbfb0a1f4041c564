#include "scene/planet.h"
#include "support/files.h"

#include <cmath>
#include <nlohmann/json.hpp>

using namespace alpenglow;
using test::expect_error;

namespace {

void expect_same(ExponentialMedium const& a, ExponentialMedium const& b) {
    EXPECT_EQ(a.scattering, b.scattering);
    EXPECT_EQ(a.extinction, b.extinction);
    EXPECT_EQ(a.scale_height, b.scale_height);
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
    expect_same(file.air.rayleigh, built_in.air.rayleigh);
    expect_same(file.air.aerosol, built_in.air.aerosol);
    EXPECT_EQ(file.air.aerosol_g, built_in.air.aerosol_g);
    EXPECT_EQ(file.air.ozone_absorption, built_in.air.ozone_absorption);
    EXPECT_EQ(file.air.ozone_centre, built_in.air.ozone_centre);
    EXPECT_EQ(file.air.ozone_half_width, built_in.air.ozone_half_width);
    EXPECT_EQ(file.look, built_in.look);
    EXPECT_EQ(file.ground_albedo, built_in.ground_albedo);
    EXPECT_EQ(file.solar_irradiance, built_in.solar_irradiance);
    EXPECT_NEAR(file.sun_angular_radius, built_in.sun_angular_radius, 1e-16); // through degrees
}

TEST(PlanetFiles, earth_has_300_dobson_units_and_a_lambda_to_the_minus_fourth_sky) {
    Air const air = make_earth().air;
    // Zenith optical depth of a tent: peak times half its base.
    glm::dvec3 const depth = air.ozone_absorption * air.ozone_half_width;
    constexpr double LAST_DIGIT = 5.1e-6; // rounded, as published
    EXPECT_NEAR(depth.x, 0.00975, LAST_DIGIT);
    EXPECT_NEAR(depth.y, 0.02822, LAST_DIGIT);
    EXPECT_NEAR(depth.z, 0.00128, LAST_DIGIT);
    constexpr double MICROMETRES[] = {0.680, 0.550, 0.440};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(air.rayleigh.scattering[i], 1.24062e-6 * std::pow(MICROMETRES[i], -4), 1e-9); // their last printed digit
    }
    EXPECT_NEAR(air.aerosol.scattering.x / air.aerosol.extinction.x, 0.9, 1e-12);
}

TEST(PlanetFiles, the_other_presets) {
    Planet const hazy = stored("earth_hazy");
    EXPECT_EQ(hazy.air.aerosol_g, 0.76);
    EXPECT_NEAR(hazy.air.aerosol.scattering.y / hazy.air.aerosol.extinction.y, 0.9, 1e-12);
    expect_same(hazy.air.rayleigh, make_earth().air.rayleigh);
    Planet const dense = stored("dense");
    EXPECT_NEAR(dense.air.rayleigh.scattering.x, 0.149 / 1000, 1e-15); // the document has 1/km
    EXPECT_LT(std::exp(-dense.air.top_altitude / dense.air.rayleigh.scale_height), 1e-4) << "the top cuts the air off";
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
        {"/air/rayleigh/scale_height", 0, {"/air/rayleigh/scale_height", "out of range"}},
        {"/air/rayleigh/extinction", Json::array({1, 1, 1}), {"/air/rayleigh", "unknown key \"extinction\""}},
        {"/air/aerosol/g", 1, {"/air/aerosol/g", "out of range"}},
        {"/air/aerosol/scattering", Json::array({1, 1, 1}), {"/air/aerosol", "extinction is less than scattering"}},
        {"/air/aerosol/scattering", Json::array({-1e-6, 0, 0}), {"/air/aerosol/scattering/0", "out of range"}},
        {"/air/aerosol/scattering", Json::array({0, 0}), {"/air/aerosol/scattering", "three numbers"}},
        {"/air/aerosol/scattering", 1e-6, {"/air/aerosol/scattering", "three numbers"}},
        {"/air/ozone/half_width", 0, {"/air/ozone/half_width", "out of range"}},
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
