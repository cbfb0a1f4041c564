#include "support/render_test.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{96, 54};
constexpr int FRAMES = 90;
constexpr double LOWEST = 2, HIGHEST = 2e7; // [m]
glm::dvec3 const ROLLED(0.2, 1, 0);         // up in the picture, so that no edge crosses a whole row of pixels at once

double altitude_of(int frame) { return LOWEST * std::pow(HIGHEST / LOWEST, frame / double(FRAMES - 1)); }

/// Straight up from a plain with a ridge on it, by the same factor of altitude from frame to frame.
class FlightSteps : public RenderTest {
protected:
    using Change = std::function<void(int frame, Settings&)>;
    /// The mean absolute difference of each frame from the one before, of 255; the first is that of frame `first` + 1.
    std::vector<double> steps(int first, int last, Change const& change) {
        Stand const stand = stand_on(load_planet("earth"));
        Scene scene = scene_of({matte({0.2f, 0.22f, 0.15f})});
        add_plane(scene, 3000, 1);
        add_ridge(scene, {-2000, 1, -2500}, {2000, 1, -2500}, 800, 600);
        put(scene, stand);
        std::vector<double> result;
        ByteImage before;
        for (int frame = first; frame <= last; ++frame) {
            double const altitude = altitude_of(frame);
            // From the level to the horizon's middle: the planet stays in the lower half of the picture, and fills it at the end.
            double const dip = std::acos(stand.planet.radius / (stand.planet.radius + altitude));
            glm::dvec3 const eye(0, altitude, 0), ahead(0, -std::sin(dip), -std::cos(dip));
            Settings settings = plain_settings();
            settings.samples = 16;
            settings.cascade_size = 512;
            settings.exposure = 2;
            settings.aa = 1;
            change(frame, settings);
            ByteImage const now = picture(stand.view(stand.camera(eye, eye + ahead, glm::radians(60.0), ROLLED), sun_at(20, 40)), settings, EXTENT);
            if (frame > first) result.push_back(mean_difference(before, now));
            before = now;
        }
        return result;
    }
    static double mean_difference(ByteImage const& a, ByteImage const& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
        return sum / (0.75 * static_cast<double>(a.rgba.size())); // alpha never differs
    }
};

/// Steps that are more than twice the larger of their neighbours. A difference of 0.3 of 255 is below what rounding to 8 bits
/// and single pixels on edges make of a smooth change.
std::vector<int> jumps(std::vector<double> const& steps) {
    std::vector<int> found;
    for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
        if (steps[i] > 2 * std::max(steps[i - 1], steps[i + 1]) + 0.3) found.push_back(static_cast<int>(i));
    }
    return found;
}

/// The frame in which the camera has just passed 100 km.
int frame_behind_100_km() {
    int frame = 0;
    while (altitude_of(frame) < 1e5) ++frame;
    return frame;
}

} // namespace

TEST_F(FlightSteps, from_2_m_to_20_000_km_nothing_jumps) {
    std::vector<double> const all = steps(0, FRAMES - 1, [](int, Settings&) {});
    for (int const step : jumps(all)) {
        auto const i = static_cast<std::size_t>(step);
        ADD_FAILURE() << "at " << altitude_of(step) << " m the picture changes by " << all[i] << ", before and after by " << all[i - 1] << " and " << all[i + 1];
    }
}

TEST_F(FlightSteps, a_switch_at_100_km_is_found) {
    constexpr int AROUND = 6; // frames on either side
    int const first = frame_behind_100_km() - AROUND, last = frame_behind_100_km() + AROUND;
    auto const jumps_with = [&](Change const& change) { return jumps(steps(first, last, change)); };
    EXPECT_EQ(jumps_with([](int, Settings&) {}), std::vector<int>{});
    EXPECT_EQ(jumps_with([](int frame, Settings& settings) { settings.exposure += altitude_of(frame) >= 1e5 ? 0.3 : 0.0; }), std::vector{AROUND - 1});
    EXPECT_EQ(jumps_with([](int frame, Settings& settings) { settings.air = altitude_of(frame) < 1e5; }), std::vector{AROUND - 1});
}
