#include "support/render_test.h"

#include <algorithm>
#include <cmath>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

/// Pictures of the air alone over a black planet, in float: what 8 bits, dither and tone curve might hide is still there.
class SmoothSky : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        planet_ = make_earth();
        planet_.look = GroundLook::uniform;
        settings_ = plain_settings();
        settings_.samples = 64;
        settings_.shadows = false;
        settings_.shafts = "off";
    }
    static double dip(double altitude) { return -glm::degrees(std::acos(6.36e6 / (6.36e6 + altitude))); }
    /// Looks `elevation` degrees up to the north.
    FloatImage look(double altitude, double elevation, double fov, double sun_elevation, double sun_azimuth, Extent extent) {
        Stand const stand = stand_on(planet_, altitude);
        World const world = stand.view(stand.camera({0, 0, 0}, sun_at(elevation, 0), glm::radians(fov)), sun_at(sun_elevation, sun_azimuth));
        return radiance(world, settings_, extent);
    }
    Planet planet_;
    Settings settings_;
};

double green(FloatImage const& image, std::uint32_t x, std::uint32_t y) { return static_cast<double>(image.at(x, y)[1]); }

/// Mean of each row.
std::vector<double> rows(FloatImage const& image) {
    std::vector<double> result(image.extent.height);
    for (std::uint32_t y = 0; y < image.extent.height; ++y)
        for (std::uint32_t x = 0; x < image.extent.width; ++x) result[y] += green(image, x, y) / image.extent.width;
    return result;
}

/// A line along the horizon, in parts of the light there: by how much the lowest row of the sky differs from what the three
/// above it lead to, and by how much the highest row of the ground lies outside what is between its neighbours. The step
/// between the two is real: over black ground the ray has air behind the horizon or has none.
double largest_line(std::vector<double> const& p) {
    std::size_t sky = 4; // the lowest row of it
    for (std::size_t i = 4; i + 3 < p.size(); ++i)
        if (std::abs(p[i] - p[i + 1]) > std::abs(p[sky] - p[sky + 1])) sky = i;
    double const continued = 3 * p[sky - 1] - 3 * p[sky - 2] + p[sky - 3], ground = p[sky + 1];
    double const low = std::min(p[sky], p[sky + 2]), high = std::max(p[sky], p[sky + 2]);
    return std::max({std::abs(p[sky] - continued), low - ground, ground - high}) / std::max(p[sky], 1e-30);
}

/// The largest jump of slope from one pixel to the next, in parts of the value, against that of the picture's own bend: third
/// differences of a smooth curve vanish with the third power of the step, those of facets and bands do not.
double roughness(std::vector<double> const& p) {
    double worst = 0;
    for (std::size_t i = 1; i + 2 < p.size(); ++i)
        worst = std::max(worst, std::abs(p[i + 2] - 3 * p[i + 1] + 3 * p[i] - p[i - 1]) / std::max(p[i], 1e-30));
    return worst;
}

/// How far the worst pixel is from the mean of its eight neighbours, in parts of that mean.
double largest_speck(FloatImage const& image) {
    double worst = 0;
    for (std::uint32_t y = 1; y + 1 < image.extent.height; ++y)
        for (std::uint32_t x = 1; x + 1 < image.extent.width; ++x) {
            double around = 0;
            for (std::uint32_t j = y - 1; j <= y + 1; ++j)
                for (std::uint32_t i = x - 1; i <= x + 1; ++i) around += (i == x && j == y) ? 0 : green(image, i, j) / 8;
            if (around > 1e-9) worst = std::max(worst, std::abs(green(image, x, y) - around) / around);
        }
    return worst;
}

} // namespace

TEST_F(SmoothSky, there_is_no_line_at_the_horizon) {
    for (double const altitude : {2.0, 500.0, 12e3, 99e3, 400e3}) {
        for (double const sun : {40.0, 3.0, -2.0}) {
            for (double const fov : {1.0, 0.1}) {
                std::vector<double> column;
                FloatImage const image = look(altitude, dip(altitude), fov, sun, 20, {9, 64});
                for (std::uint32_t y = 0; y < image.extent.height; ++y) column.push_back(green(image, 4, y));
                // Half of what an eye sees between two areas side by side.
                EXPECT_LT(largest_line(column), 0.004) << altitude << " m, sun at " << sun << ", field of " << fov;
            }
        }
    }
}

TEST_F(SmoothSky, there_is_no_band_in_the_sky) {
    for (double const altitude : {2.0, 12e3}) {
        for (double const sun : {60.0, 6.0, -4.0}) {
            auto const profile = rows(look(altitude, 30, 50, sun, 100, {9, 200}));
            EXPECT_LT(roughness(profile), 0.002) << altitude << " m, sun at " << sun;
        }
    }
}

TEST_F(SmoothSky, there_is_no_step_at_the_top_of_the_air) {
    double const top = planet_.air.top_altitude;
    for (double const sun : {30.0, -5.0}) {
        // The camera passes it: 2 m apart, the view moves by less than the float of a pixel's direction.
        FloatImage const inside = look(top - 1, -8, 40, sun, 30, {32, 32}), outside = look(top + 1, -8, 40, sun, 30, {32, 32});
        double worst = 0;
        for (std::uint32_t i = 0; i < inside.extent.pixels(); ++i) {
            double const a = inside.rgba[4 * i + 1], b = outside.rgba[4 * i + 1];
            if (a > 1e-7) worst = std::max(worst, std::abs(a - b) / a);
        }
        EXPECT_LT(worst, 0.002) << "sun at " << sun;
        // Rays pass it: seen from 400 km, the light fades out before it.
        auto const limb = rows(look(400e3, -glm::degrees(std::acos((6.36e6 + top) / 6.76e6)), 0.5, sun, 30, {9, 64}));
        double const brightest = rows(look(400e3, dip(400e3) + 0.3, 0.5, 30, 30, {9, 9}))[4];
        for (std::size_t i = 1; i < limb.size(); ++i) EXPECT_LT(std::abs(limb[i] - limb[i - 1]), 2e-5 * brightest) << i;
    }
}

TEST_F(SmoothSky, there_is_no_speck_at_a_rays_closest_approach) {
    for (double const altitude : {12e3, 400e3, 1000e3, 20000e3}) {
        for (double const sun : {30.0, -10.0}) {
            // Around the limb, and so near that a pixel is a tenth of a kilometre there.
            double const fov = glm::degrees(6.4e3 / std::sqrt(2 * 6.36e6 * altitude + altitude * altitude));
            FloatImage const image = look(altitude, dip(altitude) + 0.7 * fov, fov, sun, 60, {48, 48});
            EXPECT_LT(largest_speck(image), 0.01) << altitude << " m, sun at " << sun;
        }
    }
}
