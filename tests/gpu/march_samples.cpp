#include "support/render_test.h"

#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

constexpr Extent EXTENT{64, 36};

/// A camera that looks at the horizon. At the terminator the sun is seen as in assets/views/terminator_400km.json.
struct MarchView {
    char const* name;
    double altitude, sun, azimuth = 0; ///< [m], [degrees]; 0: the sun is ahead
};

constexpr MarchView VIEWS[] = {{"ground_17", 2, 17},     {"ground_1", 2, 1},   {"ground_minus_3", 2, -3},
                               {"high_17", 1e4, 17},     {"high_1", 1e4, 1},   {"high_minus_3", 1e4, -3},
                               {"orbit_17", 4e5, 17},    {"orbit_1", 4e5, 1},  {"orbit_minus_3", 4e5, -3},
                               {"orbit_terminator", 4e5, 2, 28}};

class MarchSamples : public RenderTest {
protected:
    FloatImage scattered_once(MarchView const& view, int samples) {
        Stand const stand = stand_on(load_planet("earth"));
        double const dip = std::acos(stand.planet.radius / (stand.planet.radius + view.altitude));
        glm::dvec3 const eye(0, view.altitude, 0), ahead(0, -std::sin(dip), -std::cos(dip));
        World const world = stand.view(stand.camera(eye, eye + ahead, glm::radians(60.0)), sun_at(view.sun, view.azimuth));
        Settings settings = plain_settings();
        settings.multiple_scattering = false;
        settings.samples = samples;
        return radiance(world, settings, EXTENT);
    }
};

/// RMS difference over the converged picture's mean.
double normalised_error(FloatImage const& picture, FloatImage const& converged) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        squares += std::pow(static_cast<double>(picture.rgba[i]) - static_cast<double>(converged.rgba[i]), 2);
        sum += static_cast<double>(converged.rgba[i]);
    }
    double const count = 3.0 * static_cast<double>(EXTENT.pixels());
    return std::sqrt(squares / count) / (sum / count);
}

} // namespace

// One test of all views: they share the tables of the air, which cost more than the pictures.
TEST_F(MarchSamples, sixteen_are_within_one_percent_and_thirty_within_half) {
    for (MarchView const& view : VIEWS) {
        SCOPED_TRACE(view.name);
        FloatImage const converged = scattered_once(view, 1024);
        EXPECT_LT(normalised_error(scattered_once(view, 16), converged), 0.01);
        EXPECT_LT(normalised_error(scattered_once(view, 30), converged), 0.005);
        EXPECT_GT(normalised_error(scattered_once(view, 4), converged), 0.005) << "nothing is looked for here";
    }
}
