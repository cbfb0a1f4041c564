#include "sandbox/arguments.h"
#include "sandbox/command_line.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

using namespace alpenglow;

namespace {

Command parse(std::string const& line) {
    std::istringstream words(line);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) arguments.push_back(word);
    return parse_command_line(arguments);
}

/// The line of the error that `line` must give.
std::string refusal(std::string const& line) {
    try {
        parse(line);
    } catch (Error const& error) {
        EXPECT_EQ(error.exit_code(), 2) << line;
        std::string const text = error.what();
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        return text;
    }
    ADD_FAILURE() << "accepted: " << line;
    return {};
}

void expect_refused(std::string const& line, std::string const& naming) {
    std::string const text = refusal(line);
    EXPECT_NE(text.find(naming), std::string::npos) << line << " gave: " << text;
}

} // namespace

TEST(CommandLine, fly_without_options_is_the_default_flight) {
    auto const fly = std::get<FlyOptions>(parse("fly"));
    EXPECT_FALSE(fly.scene || fly.planet || fly.flight || fly.device || fly.headless || fly.validate);
    EXPECT_FALSE(fly.size);
    EXPECT_EQ(fly.frames, 24);
    EXPECT_EQ(fly.out, "out/flight");
}

TEST(CommandLine, fly_takes_its_options) {
    auto const fly = std::get<FlyOptions>(
        parse("fly alps.glb --planet earth_hazy --flight f.json --headless --size 640x360 --frames 7 --out o --device 1 --validate"));
    EXPECT_EQ(fly.scene, "alps.glb");
    EXPECT_EQ(fly.planet, "earth_hazy");
    EXPECT_EQ(fly.flight, "f.json");
    EXPECT_TRUE(fly.headless && fly.validate);
    EXPECT_EQ(fly.size, (Extent{640, 360}));
    EXPECT_EQ(fly.frames, 7);
    EXPECT_EQ(fly.out, "o");
    EXPECT_EQ(fly.device, 1);
}

TEST(CommandLine, studio_takes_scenes) {
    auto const studio = std::get<StudioOptions>(
        parse("studio a.glb models --size 96x64 --out o.png --scene-index 2 --set aa=4 b.gltf --device 1"));
    EXPECT_EQ(studio.scenes, (std::vector<std::filesystem::path>{"a.glb", "models", "b.gltf"}));
    EXPECT_EQ(studio.size, (Extent{96, 64}));
    EXPECT_EQ(studio.out, "o.png");
    EXPECT_EQ(studio.scene_index, 2);
    EXPECT_EQ(studio.overrides, (std::vector<Override>{{"aa", "4"}}));
    EXPECT_EQ(studio.device, 1);
    expect_refused("studio", "SCENE");
}

TEST(CommandLine, render_takes_views_formats_and_settings) {
    auto const render = std::get<RenderOptions>(
        parse("render a.json b.json --scene s.gltf --format png,exr --set samples=64 shafts=off --set show=depth c.json"));
    EXPECT_EQ(render.views, (std::vector<std::filesystem::path>{"a.json", "b.json", "c.json"}));
    EXPECT_EQ(render.scene, "s.gltf");
    EXPECT_TRUE(render.png && render.exr);
    EXPECT_EQ(render.overrides, (std::vector<Override>{{"samples", "64"}, {"shafts", "off"}, {"show", "depth"}}));
    auto const exr = std::get<RenderOptions>(parse("render --format exr --show gbuffer.normal a.json"));
    EXPECT_TRUE(exr.exr && !exr.png);
    EXPECT_EQ(exr.overrides, (std::vector<Override>{{"show", "gbuffer.normal"}}));
}

TEST(CommandLine, placement_is_laid_over_the_files_one_by_one) {
    auto const render = std::get<RenderOptions>(parse("render v.json --at -45.5,7,1200 --curve"));
    std::optional<Placement> placement = Placement{{1, 2, 3}, 0.5, 2, false};
    render.placement.apply_to(placement);
    EXPECT_DOUBLE_EQ(placement->anchor.latitude, -45.5 * M_PI / 180);
    EXPECT_DOUBLE_EQ(placement->anchor.longitude, 7 * M_PI / 180);
    EXPECT_DOUBLE_EQ(placement->anchor.altitude, 1200);
    EXPECT_EQ(placement->yaw, 0.5);
    EXPECT_EQ(placement->scale, 2);
    EXPECT_TRUE(placement->curve);

    std::optional<Placement> none;
    PlacementOptions{}.apply_to(none);
    EXPECT_FALSE(none);
    std::get<RenderOptions>(parse("render v.json --yaw -90 --scale 3")).placement.apply_to(none);
    EXPECT_DOUBLE_EQ(none->yaw, -M_PI / 2);
    EXPECT_EQ(none->scale, 3);
}

TEST(CommandLine, terrain_and_bench_and_devices) {
    auto const terrain = std::get<TerrainCommandOptions>(parse("terrain --seed 9 --side 50.5 --resolution 512 --erosion 0.5 --out t.glb"));
    EXPECT_EQ(terrain.terrain.seed, 9u);
    EXPECT_EQ(terrain.terrain.side_km, 50.5);
    EXPECT_EQ(terrain.terrain.resolution, 512);
    EXPECT_EQ(terrain.terrain.erosion, 0.5);
    EXPECT_EQ(terrain.out, "t.glb");
    auto const bench = std::get<BenchOptions>(parse("bench v.json --frames 3 --json"));
    EXPECT_TRUE(bench.json);
    EXPECT_EQ(bench.frames, 3);
    EXPECT_FALSE(bench.load);
    EXPECT_TRUE(std::holds_alternative<DevicesOptions>(parse("devices")));
}

TEST(CommandLine, bench_takes_views_or_a_scene_to_load) {
    auto const given = std::get<BenchOptions>(parse("bench --load s.glb --frames 3 --json --set largest_texture=64"));
    EXPECT_EQ(given.load, "s.glb");
    EXPECT_EQ(given.frames, 3);
    EXPECT_TRUE(given.json && given.views.empty());
    EXPECT_EQ(std::get<BenchOptions>(parse("bench --load")).load, "");
    EXPECT_EQ(std::get<BenchOptions>(parse("bench --load --json")).load, "");
    expect_refused("bench", "VIEW.json, --load, --plot or --switches is required");
    expect_refused("bench v.json --load s.glb", "VIEW.json");
    expect_refused("bench --load s.glb --size 64x36", "--size");
    expect_refused("bench --load s.glb --at 1,2", "--at");
}

TEST(CommandLine, bench_of_switches_needs_no_view_and_nothing_else_to_measure) {
    auto const given = std::get<BenchOptions>(parse("bench --switches --size 64x36 --frames 2"));
    EXPECT_TRUE(given.switches && given.views.empty());
    EXPECT_EQ(given.size, (Extent{64, 36}));
    EXPECT_EQ(std::get<BenchOptions>(parse("bench v.json --switches")).views.size(), 1u);
    expect_refused("bench --switches --plot p.svg", "--plot");
    expect_refused("bench --switches --load s.glb", "--switches");
}

TEST(CommandLine, evaluate_takes_lists_of_views_and_known_models) {
    auto const all = std::get<EvaluateOptions>(parse("evaluate"));
    EXPECT_TRUE(all.views.empty() && all.models.empty() && !all.json && !all.references && !all.check);
    auto const some = std::get<EvaluateOptions>(parse("evaluate --views a.json b.json --model march --references r --heatmaps h "
                                                      "--document d.md --check c.md --set samples=64 --json"));
    EXPECT_EQ(some.views, (std::vector<std::filesystem::path>{"a.json", "b.json"}));
    EXPECT_EQ(some.models, (std::vector<std::string>{"march"}));
    EXPECT_EQ(some.references, "r");
    EXPECT_EQ(some.heatmaps, "h");
    EXPECT_EQ(some.document, "d.md");
    EXPECT_EQ(some.check, "c.md");
    EXPECT_EQ(some.overrides, (std::vector<Override>{{"samples", "64"}}));
    EXPECT_TRUE(some.json);
    expect_refused("evaluate --model hillaire", "there is no model 'hillaire' (give all, or some of march|naive|tables)");
    expect_refused("evaluate --views", "--views");
}

TEST(CommandLine, compare_takes_two_pictures) {
    auto const plain = std::get<CompareOptions>(parse("compare test.exr reference.exr"));
    EXPECT_EQ(plain.test, "test.exr");
    EXPECT_EQ(plain.reference, "reference.exr");
    EXPECT_FALSE(plain.exposure || plain.heatmap || plain.json);
    auto const full = std::get<CompareOptions>(parse("compare a.png b.png --exposure -2.5 --heatmap h.png --json"));
    EXPECT_EQ(full.exposure, -2.5);
    EXPECT_EQ(full.heatmap, "h.png");
    EXPECT_TRUE(full.json);
    expect_refused("compare a.exr", "REFERENCE");
    expect_refused("compare a.exr b.exr c.exr", "c.exr");
    expect_refused("compare a.exr b.exr --exposure 99", "--exposure");
}

TEST(CommandLine, every_command_has_help) {
    EXPECT_NE(std::get<TextToPrint>(parse("--help")).text.find("render"), std::string::npos);
    EXPECT_EQ(std::get<TextToPrint>(parse("--version")).text.find("alpenglow "), 0u);
    for (auto const& [command, option] : {std::pair{"fly", "--headless"}, std::pair{"render", "--format"}, std::pair{"terrain", "--seed"},
                                          std::pair{"bench", "--json"}, std::pair{"compare", "--heatmap"}, std::pair{"evaluate", "--model"}}) {
        std::string const help = std::get<TextToPrint>(parse(std::string(command) + " --help")).text;
        EXPECT_NE(help.find(std::string("alpenglow ") + command), std::string::npos) << help;
        EXPECT_NE(help.find(option), std::string::npos) << help;
    }
    EXPECT_NE(std::get<TextToPrint>(parse("devices --help")).text.find("devices"), std::string::npos);
}

TEST(CommandLine, wrong_use_says_what_and_what_to_do) {
    expect_refused("", "no command");
    expect_refused("paint", "no command 'paint'");
    expect_refused("--paint", "alpenglow --help");
    expect_refused("render", "alpenglow render --help");
    expect_refused("render v.json --paint", "--paint");
    expect_refused("fly a.glb b.glb", "b.glb");
    expect_refused("fly --size 10x10", "--size '10x10'");
    expect_refused("fly --size", "alpenglow fly --help");
    expect_refused("fly --frames 0", "from 1 to 100000");
    expect_refused("fly --frames 100001", "--frames");
    expect_refused("fly --frames 3 --frames 4", "--frames");
    expect_refused("fly --out --headless", "--out needs a value");
    expect_refused("render v.json --format bmp", "png, exr or png,exr");
    expect_refused("render v.json --set samples", "NAME=VALUE");
    expect_refused("render v.json --at 91,0", "--at '91,0'");
    expect_refused("render v.json --scale 0", "--scale");
    expect_refused("render v.json --scale nan", "--scale");
    expect_refused("render v.json --device -1", "--device");
    expect_refused("terrain --out t.obj", ".gltf or .glb");
    expect_refused("terrain --seed 4294967296", "--seed");
    expect_refused("devices now", "now");
}

TEST(Arguments, numbers_are_taken_whole_and_finite) {
    EXPECT_EQ(parse_number("--x", "-1.5e2", -1000, 1000), -150);
    for (char const* text : {"", " 1", "1 ", "1,5", "1.5x", "nan", "inf", "-inf", "1e999", "0x10", "1001", "one"}) {
        EXPECT_THROW(parse_number("--x", text, -1000, 1000), Error) << text;
    }
    EXPECT_EQ(parse_integer("--n", "12", 0, 99), 12);
    for (char const* text : {"", "1.0", "1e1", "-1", "100", "99999999999999999999", "1 2"}) {
        EXPECT_THROW(parse_integer("--n", text, 0, 99), Error) << text;
    }
}

TEST(Arguments, sizes) {
    EXPECT_EQ(parse_size("--size", "16x16384"), (Extent{16, 16384}));
    for (char const* text : {"", "x", "100", "100x", "x100", "15x100", "100x16385", "100x100x100", "100X100", "-100x100", "1e2x100", "100*100"}) {
        EXPECT_THROW(parse_size("--size", text), Error) << text;
    }
}

TEST(Arguments, places) {
    EXPECT_EQ(parse_place("--at", "0,360").longitude, 2 * M_PI);
    for (char const* text : {"", "1", "1,2,3,4", "90.1,0", "0,361", "0,nan", "a,b", "1,", ",1", "1,2,"}) {
        EXPECT_THROW(parse_place("--at", text), Error) << text;
    }
}

TEST(Arguments, overrides_split_at_the_first_equals_sign) {
    EXPECT_EQ(parse_override("--set", "show=a=b"), (Override{"show", "a=b"}));
    EXPECT_EQ(parse_override("--set", "show="), (Override{"show", ""}));
    EXPECT_THROW(parse_override("--set", "=1"), Error);
}
