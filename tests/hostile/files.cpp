#include "support/refusal.h"

using namespace alpenglow;
using test::Refusal;

namespace {

constexpr char const* CAMERA = R"({"latitude": 46, "longitude": 7.5, "altitude": 900})";

std::string view(std::string const& camera, std::string const& more = "") { return "{\"camera\": " + camera + more + "}"; }
std::string view_with(std::string const& key, std::string const& value) { return view(CAMERA, ", \"" + key + "\": " + value); }

/// A view that must be refused.
Refusal bad_view(std::string name, std::string text, std::vector<std::string> says) {
    says.push_back("bad.json");
    return {std::move(name), {"render", "bad.json", "--out", "out", "--size", "64x36"}, 3, std::move(says), {{"bad.json", std::move(text)}}};
}

std::string planet(std::string const& radius, std::string const& more = "") {
    return R"({"name": "p", "source": "none", "radius": )" + radius + more +
           R"(, "ground": {"look": "uniform", "albedo": [0.1, 0.1, 0.1]}, "sun": {"irradiance": [1, 1, 1], "angular_radius": 0.27}})";
}

Refusal bad_planet(std::string name, std::string text, std::vector<std::string> says) {
    says.push_back("bad.json");
    return {std::move(name), {"render", "view.json", "--planet", "bad.json", "--out", "out", "--size", "64x36"}, 3, std::move(says),
            {{"view.json", view(CAMERA)}, {"bad.json", std::move(text)}}};
}

Refusal bad_flight(std::string name, std::string text, std::vector<std::string> says) {
    says.push_back("bad.json");
    return {std::move(name), {"fly", "--headless", "--flight", "bad.json", "--out", "out", "--size", "64x36", "--frames", "2"}, 3, std::move(says),
            {{"bad.json", std::move(text)}}};
}

std::string flight(std::string const& second_key) {
    return std::string(R"({"keys": [{"time": 0, "camera": )") + CAMERA + "}" + second_key + "]}";
}

Refusal bad_scene(std::string name, std::string file, std::string text, std::vector<std::string> says) {
    says.push_back(file);
    Refusal row{std::move(name), {"render", "view.json", "--scene", file, "--out", "out", "--size", "64x36"}, 3, std::move(says), {{"view.json", view(CAMERA)}}};
    row.files[file] = std::move(text);
    return row;
}

std::vector<Refusal> rows() {
    return {
        bad_view("view_unknown_key", view_with("sampels", "8"), {"sampels", "samples"}),
        bad_view("view_unknown_camera_key", view(R"({"latitude": 46, "longitude": 7.5, "altitude": 900, "fow": 60})"), {"/camera", "fow", "fov"}),
        bad_view("view_without_camera", "{}", {"camera"}),
        bad_view("view_camera_of_wrong_type", view("7"), {"/camera"}),
        bad_view("view_text_for_number", view(R"({"latitude": "46", "longitude": 7.5, "altitude": 900})"), {"/camera/latitude", "not a number"}),
        bad_view("view_number_for_switch", view_with("shadows", "1"), {"/shadows", "true or false"}),
        bad_view("view_fraction_for_whole_number", view_with("samples", "8.5"), {"/samples", "whole number"}),
        bad_view("view_sample_count_out_of_range", view_with("samples", "4096"), {"/samples", "4 to 1024"}),
        bad_view("view_unknown_curve", view_with("curve", "\"film\""), {"/curve", "filmic"}),
        bad_view("view_sun_nan", view_with("sun", R"({"elevation": NaN, "azimuth": 85})"), {"NaN"}),
        bad_view("view_sun_beyond_double", view_with("sun", R"({"elevation": 1e999, "azimuth": 85})"), {"1e999"}),
        bad_view("view_sun_infinite", view_with("sun", R"({"elevation": Infinity, "azimuth": 85})"), {"Infinity"}),
        bad_view("view_sun_below_nadir", view_with("sun", R"({"elevation": -91, "azimuth": 85})"), {"/sun/elevation"}),
        bad_view("view_sun_on_no_day", view_with("sun", R"({"utc": "2026-02-30T12:00:00Z"})"), {"/sun/utc"}),
        bad_view("view_camera_inside_the_planet", view(R"({"latitude": 46, "longitude": 7.5, "altitude": -10})"), {"/camera/altitude"}),
        bad_view("view_camera_without_field_of_view", view(R"({"latitude": 46, "longitude": 7.5, "altitude": 900, "fov": 0})"), {"/camera/fov"}),
        bad_view("view_key_twice", view(CAMERA, R"(, "samples": 8, "samples": 16)"), {"samples", "twice"}),
        bad_view("view_not_json", "camera: 1", {"not JSON"}),
        bad_view("view_empty", "", {"not JSON"}),
        bad_view("view_nested_deeply", std::string(100'000, '['), {"nested"}),
        {"view_shows_an_unknown_image", {"render", "bad.json", "--out", "out", "--size", "64x36"}, 3, {"view bad", "normals", "normal"},
         {{"bad.json", view_with("show", "\"normals\"")}}},
        {"view_missing", {"render", "none.json", "--out", "out"}, 3, {"none.json", "No such file"}},
        {"view_is_a_folder", {"render", "folder", "--out", "out"}, 3, {"folder", "regular file"}, {{"folder/x", ""}}, {}, {}, {}, {}},
        {"view_is_a_device", {"render", "/dev/zero", "--out", "out"}, 3, {"/dev/zero", "regular file"}},
        {"second_view_is_bad", {"render", "good.json", "bad.json", "--out", "out"}, 3, {"bad.json", "extra"},
         {{"good.json", view(CAMERA)}, {"bad.json", view_with("extra", "1")}}},

        bad_planet("planet_radius_zero", planet("0"), {"/radius"}),
        bad_planet("planet_radius_negative", planet("-6360000"), {"/radius"}),
        bad_planet("planet_radius_beyond_double", planet("1e999"), {"1e999"}),
        bad_planet("planet_unknown_key", planet("6360000", R"(, "moons": 2)"), {"moons"}),
        bad_planet("planet_radius_of_wrong_type", planet("[1]"), {"/radius"}),
        bad_planet("planet_air_without_a_top", planet("6360000", R"(, "air": {"top_altitude": 0, "components": [{"name": "gas", "scattering": [0, 0, 0], "profile": {"scale_height": 8000}}]})"),
                   {"/air/top_altitude"}),
        bad_planet("planet_not_json", "[", {"not JSON"}),
        {"planet_of_unknown_name", {"render", "view.json", "--planet", "mars", "--out", "out"}, 3, {"mars"}, {{"view.json", view(CAMERA)}}},
        {"reference_of_a_missing_scene", {"reference", "view.json", "later.json", "--out", "out", "--size", "16x16"}, 3, {"none.glb", "later"}, {{"view.json", view(CAMERA)}, {"later.json", view_with("scene", R"({"file": "none.glb"})")}}},
        {"reference_of_a_missing_planet", {"reference", "view.json", "later.json", "--out", "out", "--size", "16x16"}, 3, {"none.json", "No such file"}, {{"view.json", view(CAMERA)}, {"later.json", view_with("planet", "\"none.json\"")}}},
        {"planet_missing", {"render", "view.json", "--planet", "none.json", "--out", "out"}, 3, {"none.json", "No such file"}, {{"view.json", view(CAMERA)}}},

        bad_flight("flight_of_one_key", flight(""), {"/keys"}),
        bad_flight("flight_back_in_time", flight(std::string(R"(, {"time": -1, "camera": )") + CAMERA + "}"), {"/keys/1"}),
        bad_flight("flight_unknown_key", flight(std::string(R"(, {"time": 1, "speed": 3, "camera": )") + CAMERA + "}"), {"/keys/1", "speed"}),
        bad_flight("flight_into_the_planet", flight(R"(, {"time": 1, "camera": {"latitude": 0, "longitude": 0, "altitude": -5}})"), {"/keys/1/camera/altitude"}),
        bad_flight("flight_key_of_wrong_type", flight(", 7"), {"/keys/1"}),
        bad_flight("flight_not_json", "{", {"not JSON"}),
        {"bench_of_a_missing_scene", {"bench", "--load", "none.glb"}, 3, {"none.glb", "No such file"}},
        {"flight_missing", {"fly", "--headless", "--flight", "none.json", "--out", "out"}, 3, {"none.json", "No such file"}},

        bad_scene("scene_not_gltf", "scene.glb", "this is no glTF", {"not"}),
        bad_scene("scene_a_picture", "scene.gltf", "\x89PNG\r\n\x1a\n", {}),
        bad_scene("scene_empty", "scene.gltf", "", {}),
        bad_scene("scene_json_but_not_gltf", "scene.gltf", "{}", {"asset"}),
        bad_scene("scene_of_gltf_1", "scene.gltf", R"({"asset": {"version": "1.0"}})", {"1.0"}),
        bad_scene("scene_with_a_buffer_outside", "scene.gltf",
                  R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "../../etc/passwd", "byteLength": 10}],
                      "bufferViews": [{"buffer": 0, "byteLength": 10}]})", {"/buffers/0"}),
        bad_scene("scene_with_a_missing_buffer", "scene.gltf",
                  R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "none.bin", "byteLength": 10}],
                      "bufferViews": [{"buffer": 0, "byteLength": 10}]})", {"none.bin"}),
        {"scene_missing", {"render", "view.json", "--scene", "none.glb", "--out", "out"}, 3, {"none.glb", "No such file"}, {{"view.json", view(CAMERA)}}},
        {"scene_a_folder", {"render", "view.json", "--scene", "scene.gltf", "--out", "out"}, 3, {"scene.gltf", "regular file"},
         {{"view.json", view(CAMERA)}, {"scene.gltf/x", ""}}},
        {"assets_missing", {"render", "view.json", "--out", "out"}, 3, {"earth"}, {{"view.json", view(CAMERA)}}, {{"ALPENGLOW_ASSETS", "/nonexistent"}}},
    };
}

class BadFile : public testing::TestWithParam<Refusal> {};

} // namespace

TEST_P(BadFile, is_refused_in_one_line) { test::expect_refusal(GetParam(), test::TemporaryFolder().path()); }

INSTANTIATE_TEST_SUITE_P(Files, BadFile, testing::ValuesIn(rows()), test::name_of);

TEST(UnreadableFile, is_refused_in_one_line) {
    test::TemporaryFolder const folder;
    std::filesystem::permissions(folder.write("view.json", view(CAMERA)), std::filesystem::perms::none);
    Refusal row{"unreadable", {"render", "view.json", "--out", "out"}, 3, {"view.json", "Permission denied"}};
    row.leaves = {"view.json"};
    test::expect_refusal(row, folder.path());
}
