#include "support/refusal.h"

using namespace alpenglow;
using test::Refusal;

namespace {

using Environment = std::map<std::string, std::string>;

std::map<std::string, std::string> const VIEWS = {{"a.json", R"({"camera": {"latitude": 46, "longitude": 7.5, "altitude": 900}, "samples": 4})"},
                                                  {"b.json", R"({"camera": {"latitude": 46, "longitude": 7.5, "altitude": 9000}, "samples": 4})"}};
std::vector<std::string> const RENDER = {"render", "a.json", "b.json", "--out", "out", "--size", "64x36"};
Environment const NO_DRIVER = {{"VK_DRIVER_FILES", "/nonexistent"}, {"VK_ICD_FILENAMES", "/nonexistent"}};

/// The layer beside this program that makes a device fail.
Environment sabotage(std::string const& how) {
    return {{"VK_LAYER_PATH", ALPENGLOW_LAYERS}, {"VK_INSTANCE_LAYERS", "VK_LAYER_ALPENGLOW_saboteur"}, {"ALPENGLOW_SABOTAGE", how}};
}

std::vector<std::string> with(std::vector<std::string> arguments, std::vector<std::string> const& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::vector<Refusal> rows() {
    std::vector<std::string> const fly = {"fly", "--headless", "--planet", "airless", "--flight", "flight.json", "--out", "out", "--size", "64x36", "--frames", "3"};
    std::map<std::string, std::string> const flight = {{"flight.json", R"({"keys": [{"time": 0, "camera": {"latitude": 46, "longitude": 7.5, "altitude": 900}},
        {"time": 1, "camera": {"latitude": 46, "longitude": 7.5, "altitude": 9000}}]})"}};
    return {
        {"render_without_a_driver", RENDER, 4, {"driver", "mesa-vulkan-drivers"}, VIEWS, NO_DRIVER},
        {"fly_without_a_driver", fly, 4, {"driver", "mesa-vulkan-drivers"}, flight, NO_DRIVER},
        {"bench_without_a_driver", {"bench", "a.json"}, 4, {"driver", "mesa-vulkan-drivers"}, VIEWS, NO_DRIVER},
        {"devices_without_a_driver", {"devices"}, 4, {"driver", "mesa-vulkan-drivers"}, {}, NO_DRIVER},
        {"no_such_device", with(RENDER, {"--device", "63"}), 4, {"--device", "63", "alpenglow devices"}, VIEWS},
        {"device_of_vulkan_1_2", RENDER, 4, {"lacks Vulkan 1.3", "alpenglow devices"}, VIEWS, sabotage("old_vulkan")},
        {"device_without_a_feature", RENDER, 4, {"lacks dynamicRendering", "alpenglow devices"}, VIEWS, sabotage("hide_feature")},
        {"chosen_device_without_a_feature", with(RENDER, {"--device", "0"}), 4, {"lacks dynamicRendering"}, VIEWS, sabotage("hide_feature")},
        {"device_lost_in_the_first_frame", RENDER, 4, {"lost", "start again"}, VIEWS, sabotage("lose_at=1")},
        {"device_lost_while_reading_back", RENDER, 4, {"lost", "start again"}, VIEWS, sabotage("lose_at=2")},
        {"device_lost_in_the_second_frame", RENDER, 4, {"lost", "start again"}, VIEWS, sabotage("lose_at=3"), {}, {}, {"out/a.png"}},
        {"device_lost_in_a_flight", fly, 4, {"lost", "start again"}, flight, sabotage("lose_at=5"), {}, {}, {"out/frame_0000.png", "out/frame_0001.png"}},
        {"device_lost_in_a_bench", {"bench", "a.json", "--size", "64x36"}, 4, {"lost", "start again"}, VIEWS, sabotage("lose_at=2")},
        {"out_of_memory_at_the_start", RENDER, 4, {"out of device memory", "--size"}, VIEWS, sabotage("no_memory_at=1")},
        {"out_of_memory_in_a_frame", RENDER, 4, {"out of device memory", "--size"}, VIEWS, sabotage("no_memory_at=6")},
    };
}

class BadDevice : public testing::TestWithParam<Refusal> {};

} // namespace

TEST_P(BadDevice, is_reported_in_one_line) { test::expect_refusal(GetParam(), test::TemporaryFolder().path()); }

INSTANTIATE_TEST_SUITE_P(Devices, BadDevice, testing::ValuesIn(rows()), test::name_of);

/// The layer by itself changes nothing: what fails above fails by the sabotage.
TEST(Saboteur, without_a_plan_lets_everything_pass) {
    test::TemporaryFolder const folder;
    for (auto const& [name, text] : VIEWS) folder.write(name, text);
    test::ProcessResult const result = test::run({.program = ALPENGLOW_PROGRAM, .arguments = RENDER, .environment = sabotage(""), .folder = folder.path()});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(test::files_below(folder.path()).contains("out/b.png"));
}

TEST(Devices, says_why_a_device_is_refused) {
    test::ProcessResult const result = test::run({.program = ALPENGLOW_PROGRAM, .arguments = {"devices"}, .environment = sabotage("hide_feature")});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.output.find("dynamicRendering"), std::string::npos) << result.output;
}
