#include "scene/view.h"
#include "support/files.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

using namespace alpenglow;
using test::expect_error;
using Json = nlohmann::json;

namespace {

constexpr char GOOD[] = R"({
    "planet": "dense", "scene": "default",
    "camera": {"latitude": 46, "longitude": 7.5, "altitude": 900, "heading": 80, "pitch": -6, "roll": 1, "fov": 55},
    "sun": {"elevation": 7, "azimuth": 85}, "exposure": 2.5, "samples": 64, "shafts": "off", "curve": "exponential"
})";

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

View load_text(std::string const& text) {
    test::TemporaryFolder const folder;
    return load_view(folder.write("bad.json", text));
}

/// The good view with one value replaced (or removed, by a null), read back.
View load_changed(std::string const& pointer, Json const& value) {
    Json file = Json::parse(GOOD);
    Json::json_pointer const at(pointer);
    if (value.is_null()) file[at.parent_pointer()].erase(at.back());
    else file[at] = value;
    return load_text(file.dump());
}

void expect_same(View const& a, View const& b) {
    EXPECT_EQ(a.planet, b.planet);
    EXPECT_EQ(a.scene, b.scene);
    ASSERT_EQ(a.placement.has_value(), b.placement.has_value());
    constexpr double DIGITS = 1e-14; // 12 decimals of a degree
    if (a.placement) {
        EXPECT_NEAR(a.placement->anchor.latitude, b.placement->anchor.latitude, DIGITS);
        EXPECT_NEAR(a.placement->anchor.longitude, b.placement->anchor.longitude, DIGITS);
        EXPECT_EQ(a.placement->anchor.altitude, b.placement->anchor.altitude);
        EXPECT_NEAR(a.placement->yaw, b.placement->yaw, DIGITS);
        EXPECT_EQ(a.placement->scale, b.placement->scale);
        EXPECT_EQ(a.placement->curve, b.placement->curve);
    }
    EXPECT_NEAR(a.camera.place.latitude, b.camera.place.latitude, DIGITS);
    EXPECT_NEAR(a.camera.place.longitude, b.camera.place.longitude, DIGITS);
    EXPECT_EQ(a.camera.place.altitude, b.camera.place.altitude);
    EXPECT_NEAR(a.camera.heading, b.camera.heading, DIGITS);
    EXPECT_NEAR(a.camera.pitch, b.camera.pitch, DIGITS);
    EXPECT_NEAR(a.camera.roll, b.camera.roll, DIGITS);
    EXPECT_NEAR(a.camera.vertical_fov, b.camera.vertical_fov, DIGITS);
    EXPECT_EQ(a.sun.utc, b.sun.utc);
    if (!a.sun.utc) {
        EXPECT_NEAR(a.sun.elevation, b.sun.elevation, DIGITS);
        EXPECT_NEAR(a.sun.azimuth, b.sun.azimuth, DIGITS);
    }
    EXPECT_EQ(a.settings, b.settings);
}

} // namespace

TEST(ViewFiles, say_what_they_say) {
    test::TemporaryFolder const folder;
    View const view = load_view(folder.write("morning.json", GOOD));
    EXPECT_EQ(view.name, "morning");
    EXPECT_EQ(view.planet, "dense");
    EXPECT_EQ(view.scene, "default");
    EXPECT_FALSE(view.placement);
    EXPECT_DOUBLE_EQ(view.camera.place.latitude, radians(46));
    EXPECT_DOUBLE_EQ(view.camera.place.longitude, radians(7.5));
    EXPECT_EQ(view.camera.place.altitude, 900);
    EXPECT_DOUBLE_EQ(view.camera.heading, radians(80));
    EXPECT_DOUBLE_EQ(view.camera.pitch, radians(-6));
    EXPECT_DOUBLE_EQ(view.camera.roll, radians(1));
    EXPECT_DOUBLE_EQ(view.camera.vertical_fov, radians(55));
    EXPECT_DOUBLE_EQ(view.sun.elevation, radians(7));
    EXPECT_DOUBLE_EQ(view.sun.azimuth, radians(85));
    EXPECT_EQ(view.settings, (Settings{.samples = 64, .shafts = "off", .exposure = 2.5, .curve = "exponential"}));
}

TEST(ViewFiles, paths_start_from_the_files_folder) {
    test::TemporaryFolder const folder;
    View const view = load_view(folder.write("views/a.json", R"({"planet": "../mars.json", "scene": {"file": "../scenes/hut.glb",
        "latitude": 1, "longitude": 2, "curve": true}, "camera": {"latitude": 0, "longitude": 0, "altitude": 2}})"));
    EXPECT_EQ(view.planet, (folder.path() / "mars.json").string());
    EXPECT_EQ(view.scene, (folder.path() / "scenes/hut.glb").string());
    ASSERT_TRUE(view.placement);
    EXPECT_DOUBLE_EQ(view.placement->anchor.longitude, radians(2));
    EXPECT_EQ(view.placement->scale, 1);
    EXPECT_TRUE(view.placement->curve);
}

TEST(ViewFiles, a_view_survives_its_text) {
    View view{.planet = "/planets/mars.json", .scene = "/scenes/hütte \"1\".glb"};
    view.placement = Placement{.anchor = {0.123456789012345, -3.1, 1 / 3.0}, .yaw = 2.5, .scale = 0.01, .curve = true};
    view.camera = {.place = {-std::numbers::pi / 2, std::numbers::pi, 123456.789012345}, .heading = -3, .pitch = 1.5, .roll = 0.1, .vertical_fov = 1};
    view.sun = {.elevation = -0.1, .azimuth = 6, .utc = {}};
    view.settings = {.air = false, .samples = 5, .shadow_reach = 1234.5, .exposure = 1 / 3.0, .show = "gbuffer.normal"};
    expect_same(load_text(view_text(view)), view);
    view.sun.utc = "2026-06-21T04:30:00Z";
    view.placement.reset();
    view.scene = "default";
    expect_same(load_text(view_text(view)), view);
    expect_same(load_text(view_text(load_text(GOOD))), load_text(GOOD));
    EXPECT_NE(view_text(load_text(GOOD)).find("\"latitude\": 46.0,"), std::string::npos) << view_text(load_text(GOOD));
}

TEST(ViewFiles, every_stored_one_makes_a_world) {
    int count = 0;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(test::assets() / "views")) {
        if (!entry.is_regular_file()) continue;
        View const view = load_view(entry.path());
        Planet const planet = load_planet(test::assets() / "planets" / (view.planet + ".json"));
        World const world = make_world(view, planet);
        EXPECT_NEAR(glm::length(world.to_sun), 1, 1e-14);
        EXPECT_NEAR(glm::length(world.camera.position) - planet.radius, view.camera.place.altitude, 1e-7);
        ++count;
    }
    EXPECT_GE(count, 7 + 18);
}

TEST(ViewFiles, the_sun_stands_over_the_scene_or_else_the_camera) {
    View view = load_text(GOOD);
    glm::dvec3 const anchor = world_from_geodetic({default_anchor.latitude, default_anchor.longitude, 0}, 1);
    view.camera.place.latitude = 0; // far from the scene
    EXPECT_NEAR(glm::dot(make_world(view, make_earth()).to_sun, anchor), std::sin(radians(7)), 1e-14);
    view.scene.clear();
    glm::dvec3 const camera = world_from_geodetic({0, view.camera.place.longitude, 0}, 1);
    EXPECT_NEAR(glm::dot(make_world(view, make_earth()).to_sun, camera), std::sin(radians(7)), 1e-14);
    EXPECT_DOUBLE_EQ(default_anchor.latitude, radians(46));
    EXPECT_DOUBLE_EQ(default_anchor.longitude, radians(7.5));
}

TEST(ViewFiles, a_camera_inside_the_planet_makes_no_world) {
    View view = load_text(GOOD);
    for (double const altitude : {0.0, -5.0, std::nan("")}) {
        view.camera.place.altitude = altitude;
        expect_error(ErrorKind::bad_input, {"view bad", "inside the planet"}, [&] { make_world(view, make_earth()); });
    }
}

TEST(ViewFiles, bad_ones_are_refused_with_the_place_and_the_reason) {
    struct Case { std::string pointer; Json value; std::vector<std::string> parts; };
    std::vector<Case> const cases{
        {"/kamera", 1, {"bad.json: unknown key \"kamera\"", "did you mean camera?"}},
        {"/shaft", true, {"unknown key \"shaft\"", "did you mean shafts?"}},
        {"/x\ny\u00e9", 1, {"unknown key \"x\\ny\\u00e9\"", "the keys here are"}},
        {"/camera", nullptr, {"has no \"camera\""}},
        {"/camera/latitude", 90.5, {"/camera/latitude", "90.5 is out of range", "at most 90"}},
        {"/camera/latitude", nullptr, {"at /camera", "has no \"latitude\""}},
        {"/camera/latitute", 1, {"unknown key \"latitute\"", "did you mean latitude?"}},
        {"/camera/longitude", "7E", {"/camera/longitude", "\"7E\" is not a number"}},
        {"/camera/altitude", 0, {"/camera/altitude", "out of range", "more than 0", "above the planet's reference radius"}},
        {"/camera/altitude", -100, {"/camera/altitude", "out of range"}},
        {"/camera/altitude", 1.1e9, {"/camera/altitude", "out of range"}},
        {"/camera/fov", 0, {"/camera/fov", "at least 1 and at most 170"}},
        {"/camera/fov", 171, {"/camera/fov", "out of range"}},
        {"/camera/pitch", -91, {"/camera/pitch", "out of range"}},
        {"/camera/heading", Json::array(), {"/camera/heading", "a list is not a number"}},
        {"/sun/elevation", "NaN", {"/sun/elevation", "\"NaN\" is not a number"}},
        {"/sun/elevation", 91, {"/sun/elevation", "out of range"}},
        {"/sun/azimuth", nullptr, {"at /sun", "has no \"azimuth\""}},
        {"/sun/utc", "2026-06-21T04:30:00Z", {"at /sun", "both utc and angles"}},
        {"/sun", Json{{"utc", "yesterday"}}, {"/sun/utc", "\"yesterday\" is not a time"}},
        {"/sun", Json{{"utc", 5}}, {"/sun/utc", "5 is not a text"}},
        {"/sun", "high", {"at /sun", "\"high\" is not an object"}},
        {"/planet", 3, {"/planet", "3 is not a text"}},
        {"/planet", "", {"/planet", "no name"}},
        {"/scene", true, {"/scene", "true is not an object"}},
        {"/scene", Json{{"latitude", 1}, {"longitude", 1}}, {"/scene", "has no \"file\""}},
        {"/scene", Json{{"file", "a.glb"}, {"yaw", 5}}, {"/scene", "has no \"latitude\""}},
        {"/scene", Json{{"file", "a.glb"}, {"latitude", 1}, {"longitude", 1}, {"scale", 0}}, {"/scene/scale", "out of range"}},
        {"/scene", Json{{"file", "a.glb"}, {"latitude", 1}, {"longitude", 1}, {"curve", 1}}, {"/scene/curve", "true or false"}},
        {"/scene", std::string("a\0b", 3), {"/scene", "zero byte"}},
        {"/exposure", 100, {"/exposure", "out of range"}},
        {"/samples", 3, {"/samples", "3 is out of range", "4 to 1024"}},
        {"/samples", 4.5, {"/samples", "4.5 is not a whole number"}},
        {"/samples", 1e300, {"/samples", "not a whole number"}},
        {"/aa", 2, {"/aa", "1|4|16"}},
        {"/curve", "film", {"/curve", "\"film\" is out of range", "filmic|exponential"}},
        {"/shadows", "on", {"/shadows", "true or false"}},
        {"/shafts", "on", {"/shafts", "off|fast|default|exact"}},
    };
    for (Case const& c : cases) expect_error(ErrorKind::bad_input, c.parts, [&] { load_changed(c.pointer, c.value); });
    expect_error(ErrorKind::bad_input, {"bad.json", "is not JSON", "NaN"},
                 [] { load_text(R"({"sun": {"elevation": NaN, "azimuth": 0}})"); });
    expect_error(ErrorKind::bad_input, {"bad.json", "stands twice"}, [] { load_text(R"({"exposure": 1, "exposure": 2})"); });
    expect_error(ErrorKind::bad_input, {"bad.json", "a list is not an object"}, [] { load_text("[]"); });
    expect_error(ErrorKind::bad_input, {"/nonexistent/a.json", "No such file"}, [] { load_view("/nonexistent/a.json"); });
}
