#include "support/refusal.h"

using namespace alpenglow;
using test::Refusal;

namespace {

/// A command line that must be refused as wrong use.
Refusal wrong_use(std::string name, std::vector<std::string> arguments, std::vector<std::string> says) {
    return {std::move(name), std::move(arguments), 2, std::move(says), {{"view.json", R"({"camera": {"latitude": 46, "longitude": 7.5, "altitude": 900}})"}}};
}

std::vector<Refusal> rows() {
    return {
        wrong_use("no_command", {}, {"no command", "render"}),
        wrong_use("unknown_command", {"rendr"}, {"rendr", "render"}),
        wrong_use("unknown_option", {"render", "view.json", "--sizes", "64x36"}, {"--sizes"}),
        wrong_use("render_without_a_view", {"render"}, {"VIEW.json"}),
        wrong_use("option_without_value", {"render", "view.json", "--size"}, {"--size"}),
        wrong_use("size_of_nothing", {"render", "view.json", "--size", "0x0"}, {"--size", "0x0"}),
        wrong_use("size_beyond_the_largest", {"render", "view.json", "--size", "100000x100000"}, {"--size", "16384"}),
        wrong_use("size_of_one_number", {"render", "view.json", "--size", "1280"}, {"--size", "1280x720"}),
        wrong_use("unknown_setting", {"render", "view.json", "--set", "sampels=8"}, {"sampels", "samples"}),
        wrong_use("setting_without_value", {"render", "view.json", "--set", "samples"}, {"--set", "samples"}),
        wrong_use("setting_out_of_range", {"render", "view.json", "--set", "samples=2"}, {"samples", "4 to 1024"}),
        wrong_use("setting_of_wrong_type", {"render", "view.json", "--set", "shadows=7"}, {"shadows", "on or off"}),
        wrong_use("setting_nan", {"render", "view.json", "--set", "exposure=nan"}, {"exposure", "nan"}),
        wrong_use("setting_infinite", {"render", "view.json", "--set", "exposure=1e999"}, {"exposure", "1e999"}),
        wrong_use("unknown_format", {"render", "view.json", "--format", "jpeg"}, {"--format", "jpeg", "png"}),
        wrong_use("unknown_image", {"render", "view.json", "--show", "normals", "--size", "64x36", "--out", "out"}, {"normals", "normal"}),
        wrong_use("place_beyond_the_pole", {"render", "view.json", "--at", "91,0"}, {"--at", "91,0"}),
        wrong_use("place_nan", {"render", "view.json", "--at", "nan,nan"}, {"--at", "nan,nan"}),
        wrong_use("no_frames", {"bench", "view.json", "--frames", "0"}, {"--frames"}),
        wrong_use("bench_of_nothing", {"bench"}, {"VIEW.json, --load, --plot or --switches", "bench --help"}),
        wrong_use("bench_of_switches_and_a_plot", {"bench", "--switches", "--plot", "p.svg"}, {"--switches", "--plot"}),
        wrong_use("bench_of_switches_with_a_value", {"bench", "--switches=exact", "view.json"}, {"--switches"}),
        wrong_use("bench_of_views_and_loading", {"bench", "view.json", "--load", "scene.glb"}, {"--load", "VIEW.json"}),
        wrong_use("bench_of_loading_in_a_size", {"bench", "--load", "scene.glb", "--size", "64x36"}, {"--load", "--size"}),
        wrong_use("device_not_a_number", {"render", "view.json", "--device", "one"}, {"--device", "one"}),
        wrong_use("terrain_without_an_end", {"terrain", "--out", "terrain.obj"}, {"terrain.obj", ".gltf"}),
        wrong_use("terrain_of_no_size", {"terrain", "--side", "0", "--out", "t.glb"}, {"--side"}),
        wrong_use("terrain_too_large", {"terrain", "--side", "999", "--out", "t.glb"}, {"side", "400"}),
        wrong_use("unknown_model", {"evaluate", "--model", "march", "bruneton"}, {"--model", "bruneton", "march", "naive"}),
        wrong_use("evaluate_unknown_setting", {"evaluate", "--set", "sampels=8"}, {"sampels", "samples"}),
        wrong_use("compare_one_picture", {"compare", "a.exr"}, {"REFERENCE", "compare --help"}),
        wrong_use("compare_at_no_exposure", {"compare", "a.exr", "b.exr", "--exposure", "nan"}, {"--exposure", "nan"}),
        wrong_use("reference_without_a_view", {"reference"}, {"VIEW.json", "reference --help"}),
        wrong_use("reference_of_no_samples", {"reference", "view.json", "--samples", "0"}, {"--samples", "2 to"}),
        wrong_use("reference_of_no_orders", {"reference", "view.json", "--orders", "0"}, {"--orders", "1 to"}),
        wrong_use("reference_under_a_square_sun", {"reference", "view.json", "--sun", "square"}, {"--sun", "disc or point"}),
        wrong_use("reference_of_more_noise_than_there_is", {"reference", "view.json", "--noise", "2"}, {"--noise", "to 1"}),
        wrong_use("reference_of_no_threads", {"reference", "view.json", "--threads", "0"}, {"--threads"}),
        wrong_use("references_of_one_name", {"reference", "view.json", "./view.json", "--out", "out"}, {"two views are named view"}),
        wrong_use("line_break_in_a_name", {"render", "view.json", "--set", "a\nalpenglow: b=1"}, {"a alpenglow: b"}),
    };
}

class WrongCommandLine : public testing::TestWithParam<Refusal> {};

} // namespace

TEST_P(WrongCommandLine, is_refused_in_one_line) { test::expect_refusal(GetParam(), test::TemporaryFolder().path()); }

INSTANTIATE_TEST_SUITE_P(Use, WrongCommandLine, testing::ValuesIn(rows()), test::name_of);

/// The other side of the table: what is asked for in order is no error.
TEST(CommandLine, help_and_version_go_to_stdout) {
    for (std::vector<std::string> const& arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"fly", "--help"}, {"render", "--help"}, {"terrain", "--help"}, {"bench", "--help"}, {"compare", "--help"}, {"evaluate", "--help"}, {"reference", "--help"}, {"devices", "--help"}}) {
        test::ProcessResult const result = test::run({.program = ALPENGLOW_PROGRAM, .arguments = arguments});
        EXPECT_EQ(result.exit_code, 0) << arguments.front();
        EXPECT_NE(result.output, "") << arguments.front();
        EXPECT_EQ(result.errors, "") << arguments.front();
    }
}
