#include "image/codec.h"
#include "scene/gltf.h"
#include "scene/ground_query.h"
#include "scene/view.h"
#include "support/files.h"
#include "support/gltf_hills.h"
#include "support/process.h"
#include "support/x_display.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent SIZE{320, 180};
constexpr double RADIUS = 6'360'000; // [m] of assets/planets/earth.json
constexpr double PATIENCE = 120; // [s] for what takes a second on an idle machine

char const* const FLIGHT = R"({"planet": "earth", "scene": "hills.gltf", "sun": {"elevation": 30, "azimuth": 200}, "exposure": 1,
  "keys": [{"time": 0, "camera": {"latitude": 46, "longitude": 7.5, "altitude": 900, "heading": 80, "pitch": -10}},
           {"time": 600, "camera": {"latitude": 46, "longitude": 7.5, "altitude": 900, "heading": 80, "pitch": -10}}]})"; // stands: what changes is a test's doing

double brightness(ByteImage const& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += i % 4 == 3 ? 0 : image.rgba[i];
    return sum / static_cast<double>(3 * image.extent.pixels());
}

/// Share of the pixels with a channel that differs by more than 4 of 255.
double change(ByteImage const& a, ByteImage const& b) {
    std::size_t changed = 0;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        changed += std::abs(a.rgba[pixel] - b.rgba[pixel]) > 4 || std::abs(a.rgba[pixel + 1] - b.rgba[pixel + 1]) > 4 ||
                   std::abs(a.rgba[pixel + 2] - b.rgba[pixel + 2]) > 4;
    }
    return static_cast<double>(changed) / static_cast<double>(a.extent.pixels());
}

class FlyWindow : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_FALSE(display_.name().empty()) << "Xvfb did not start: " << read_text_file(folder_.path() / "xvfb.log");
        folder_.write("hills.gltf", hills_gltf());
        folder_.write("flight.json", FLIGHT);
        std::vector<std::string> arguments = {ALPENGLOW_PROGRAM, "fly", "--flight", "flight.json", "--size", "320x180", "--set", "cascade_size=512", "samples=8", "--validate"};
        BackgroundProcess::Setup const setup{.folder = folder_.path(), .output = folder_.path() / "log", .environment = {{"DISPLAY", display_.name()}, {"WAYLAND_DISPLAY", ""}}};
        program_ = std::make_unique<BackgroundProcess>(arguments, setup);
        ASSERT_TRUE(wait_until([&] { return brightness(screen()) > 10; }, PATIENCE)) << log();
        xdotool({"mousemove", "300", "170"}); // keys go to the window under the mouse
    }

    std::string log() const { return read_text_file(folder_.path() / "log"); }
    ByteImage screen() const { return display_.screenshot(SIZE); }

    void xdotool(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "xdotool");
        BackgroundProcess tool(arguments, {.environment = {{"DISPLAY", display_.name()}}});
        ASSERT_TRUE(wait_until([&] { return tool.exit_code().has_value(); }, PATIENCE));
        ASSERT_EQ(tool.exit_code(), 0) << arguments[1];
    }

    /// The screen when it has not changed for a second; on a busy machine, for thrice as long as the last input took to be seen.
    ByteImage still_screen() {
        ByteImage before = screen();
        auto const unchanged = [&] {
            std::this_thread::sleep_for(std::max(std::chrono::duration<double>(1), 3 * response_));
            ByteImage now = screen();
            bool const same = now.rgba == before.rgba;
            before = std::move(now);
            return same;
        };
        EXPECT_TRUE(wait_until(unchanged, PATIENCE)) << log();
        return before;
    }

    /// What keys or the mouse make of the screen: another picture in more than the share `least` of its pixels.
    ByteImage after(std::vector<std::string> const& input, double least) {
        ByteImage const before = screen();
        xdotool(input);
        auto const done = std::chrono::steady_clock::now();
        EXPECT_TRUE(wait_until([&] { return change(screen(), before) > least; }, PATIENCE)) << input[1] << " changed too little; " << log();
        response_ = std::chrono::steady_clock::now() - done;
        return still_screen();
    }
    ByteImage after_key(std::string const& key, double least = 0) { return after({"key", key}, least); }

    void leave() {
        xdotool({"key", "Escape"});
        ASSERT_TRUE(wait_until([&] { return program_->exit_code().has_value(); }, PATIENCE));
        EXPECT_EQ(program_->exit_code(), 0) << log(); // --validate: a message would be an error
    }

    TemporaryFolder folder_;
    XDisplay display_{folder_.path()};
    std::unique_ptr<BackgroundProcess> program_;
    std::chrono::duration<double> response_{0}; ///< from the last input to its picture
};

} // namespace

TEST_F(FlyWindow, keys_change_the_picture) {
    after_key("h", 0.2); // takes over: panel and help
    after_key("h", 0.1); // without the help
    ByteImage const plain = after_key("Tab", 0.1);
    EXPECT_GT(brightness(plain), 10);

    xdotool({"key", "shift+equal"});
    EXPECT_TRUE(wait_until([&] { return brightness(screen()) > 1.2 * brightness(plain); }, PATIENCE)) << log();
    xdotool({"key", "shift+minus"});
    EXPECT_TRUE(wait_until([&] { return screen().rgba == plain.rgba; }, PATIENCE));

    ByteImage const ahead = after({"keydown", "w", "sleep", "0.5", "keyup", "w"}, 0.02);
    xdotool({"key", "c"}); // the cascades' colours
    EXPECT_TRUE(wait_until([&] { return change(screen(), ahead) > 0.2; }, PATIENCE)) << log();
    xdotool({"key", "c"});
    EXPECT_TRUE(wait_until([&] { return change(screen(), ahead) < 0.02; }, PATIENCE)) << log();
    after_key("shift+bracketright", 0.1); // the sun, an hour on
    // The mouse turns the camera.
    after({"mousemove", "160", "90", "mousedown", "1", "sleep", "0.4", "mousemove_relative", "60", "20", "sleep", "0.4", "mouseup", "1"}, 0.1);
    ByteImage const table = after({"key", "i", "i", "i"}, 0.1); // of the model
    xdotool({"key", "m"});                                      // to one without it
    EXPECT_TRUE(wait_until([&] { return change(screen(), table) > 0.2; }, PATIENCE)) << log();
    leave();
}

TEST_F(FlyWindow, a_saved_view_is_the_picture_that_was_seen) {
    after_key("Tab"); // takes over; Tab closes the panel again
    after_key("equal");
    xdotool({"keydown", "shift", "keydown", "q", "sleep", "2.5", "keyup", "q", "keyup", "shift"}); // down to the ground
    ByteImage const seen = still_screen();
    xdotool({"key", "p"});
    auto const view_file = folder_.path() / "out/views/view_0001.json", picture_file = folder_.path() / "out/views/view_0001.png";
    ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(view_file); }, PATIENCE)) << log();
    EXPECT_EQ(read_picture(picture_file).rgba, seen.rgba);
    View const view = load_view(view_file);
    EXPECT_EQ(view.settings.exposure, 1.25);
    GroundQuery const ground(load_gltf(folder_.path() / "hills.gltf", {}), scene_placement(view), RADIUS);
    double const above_ground = view.camera.place.altitude - ground.altitude(world_from_geodetic(view.camera.place, RADIUS)).value();
    EXPECT_GT(above_ground, 2 - 1e-3);
    EXPECT_LT(above_ground, 20);
    leave();

    ProcessResult const render = run({.program = ALPENGLOW_PROGRAM, .arguments = {"render", "out/views/view_0001.json", "--size", "320x180", "--out", "again"}, .folder = folder_.path()});
    EXPECT_EQ(render.exit_code, 0) << render.errors;
    EXPECT_EQ(read_picture(folder_.path() / "again/view_0001.png").rgba, seen.rgba);
}

TEST_F(FlyWindow, follows_the_size_of_its_window) {
    ByteImage const flight = screen();
    xdotool({"mousemove", "297", "170"});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(change(screen(), flight), 0.1); // a touched mouse takes nothing over
    xdotool({"mousemove", "250", "150"});
    EXPECT_TRUE(wait_until([&] { return change(screen(), flight) > 0.2; }, PATIENCE)) << "a moved mouse does not bring the panel; " << log();
    after_key("Tab");
    xdotool({"search", "--name", "Alpenglow", "windowsize", "500", "340"});
    auto const corner = [&] {
        ByteImage const image = display_.screenshot({500, 340});
        return int(image.at(490, 10)[2]); // sky, where there was no window before
    };
    EXPECT_TRUE(wait_until([&] { return corner() > 20; }, PATIENCE)) << log();
    xdotool({"search", "--name", "Alpenglow", "windowunmap", "sleep", "0.3", "windowmap", "windowsize", "200", "120"});
    EXPECT_TRUE(wait_until([&] { return corner() == 0; }, PATIENCE)) << log();
    ByteImage const small = still_screen();
    EXPECT_GT(int(small.at(190, 5)[2]), 20);
    EXPECT_EQ(int(small.at(210, 5)[2]), 0);
    xdotool({"mousemove", "100", "60"});
    leave();
}

TEST(FlyWithoutWindow, says_so_and_flies_to_pictures) {
    TemporaryFolder const folder;
    folder.write("hills.gltf", hills_gltf());
    folder.write("flight.json", FLIGHT);
    ProcessResult const flight = run({.program = ALPENGLOW_PROGRAM,
                                      .arguments = {"fly", "--flight", "flight.json", "--size", "32x18", "--frames", "1", "--out", "flight", "--set", "cascade_size=256"},
                                      .environment = {{"DISPLAY", ":4242"}, {"WAYLAND_DISPLAY", ""}},
                                      .folder = folder.path()});
    EXPECT_EQ(flight.exit_code, 0) << flight.errors;
    EXPECT_NE(flight.errors.find("no window can be opened"), std::string::npos) << flight.errors;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "flight/frame_0000.png"));
}
