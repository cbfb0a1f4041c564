#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{40, 22};
constexpr int FRAMES = 60;
constexpr double SUN_STEP = 0.05, CAMERA_STEP = 1; // from frame to frame [degrees, m]

/// A forest of pillars in the east, beside what the camera sees: their shadows cross its rays.
Scene pillars() {
    Scene scene = scene_of({matte(glm::vec3(0.2f))});
    for (int row = 0; row < 12; ++row) {
        for (int column = 0; column < 3; ++column) {
            double const height = 300 + 20 * ((5 * row + 3 * column) % 13), side = 50 + 5 * ((row + 7 * column) % 7);
            add_box(scene, {1500.0 + 500 * column, height, -400.0 * row - 130 * column}, {side, height, side});
        }
    }
    return scene;
}

/// Mean of red, green and blue of each pixel, 0 to 1.
std::vector<double> grey(ByteImage const& picture) {
    std::vector<double> result;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        result.push_back((picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2]) / 765.0);
    return result;
}

/// In time, about the straight line that a pixel follows as the sun rises: that line is light which changes, not shimmer.
double variance_about_line(std::vector<std::vector<double>> const& frames, std::size_t pixel) {
    double sum = 0, squares = 0, along = 0, times = 0;
    for (int i = 0; i < FRAMES; ++i) {
        double const value = frames[static_cast<std::size_t>(i)][pixel], time = i - 0.5 * (FRAMES - 1);
        sum += value, squares += value * value, along += time * value, times += time * time;
    }
    return (squares - sum * sum / FRAMES - along * along / times) / FRAMES;
}

double variance(std::vector<std::vector<double>> const& frames, std::size_t pixel) {
    double sum = 0, squares = 0;
    for (std::vector<double> const& frame : frames) sum += frame[pixel], squares += frame[pixel] * frame[pixel];
    return (squares - sum * sum / FRAMES) / FRAMES;
}

/// 99th percentiles over pixels. What changes by less than one of 255 is not seen.
struct Unrest {
    double all, shimmer; ///< variance in time; the same about a straight line
};

double p99(std::vector<std::vector<double>> const& frames, double (*of)(std::vector<std::vector<double>> const&, std::size_t)) {
    std::vector<double> each;
    for (std::size_t i = 0; i < EXTENT.pixels(); ++i) each.push_back(std::max(of(frames, i), 1 / (255.0 * 255.0)));
    std::ranges::sort(each);
    return each[static_cast<std::size_t>(0.99 * static_cast<double>(each.size() - 1))];
}

/// The sun rises in the east while the camera flies that way and looks north-west, where light and shadow alternate along each ray.
class MovingShafts : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        put(pillars(), stand_);
    }
    /// Of `FRAMES` frames with a level of shafts. `flicker`: their samples are dithered in every second frame.
    Unrest unrest_of(char const* shafts, int exact_steps, bool flicker = false) {
        Settings settings = plain_settings();
        settings.cascade_size = 512;
        settings.ceiling_size = 256;
        settings.terrain_light_size = 0;
        settings.shadows = false; // on the ground, where their edges are what changes most
        settings.exposure = 3.5;
        settings.shafts = shafts;
        settings.exact_steps = exact_steps;
        std::vector<std::vector<double>> frames;
        for (int i = 0; i < FRAMES; ++i) {
            settings.march_dither = flicker && i % 2 == 1;
            glm::dvec3 const eye(CAMERA_STEP * i, 120, 0);
            Camera const camera = stand_.camera(eye, eye + sun_at(5, -50), glm::radians(40.0));
            frames.push_back(grey(picture(stand_.view(camera, sun_at(13 + SUN_STEP * i, 90)), settings, EXTENT)));
        }
        return {p99(frames, variance), p99(frames, variance_about_line)};
    }
    Stand stand_ = stand_on(load_planet("misty"));
};

} // namespace

// 1.1: a tenth more than what moves in truth. Brute force with 20 steps is over that bound.
TEST_F(MovingShafts, do_not_shimmer_more_than_brute_force) {
    constexpr double MOST = 1.1;
    Unrest const exact = unrest_of("exact", 200);
    for (char const* const shafts : {"default", "fast"}) {
        Unrest const found = unrest_of(shafts, 4);
        EXPECT_LE(found.all, MOST * exact.all) << shafts;
        EXPECT_LE(found.shimmer, MOST * exact.shimmer) << shafts;
    }
    // While the sun rises by 3 degrees most of the variance is the light's own way: only about it does a mistake show.
    EXPECT_GT(unrest_of("exact", 20, true).shimmer, MOST * exact.shimmer);
}
