#include "atmosphere/stars.glsl"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace alpenglow::shader;

namespace {

double luminance_of(vec3 const& c) { return 0.2126 * double(c.x) + 0.7152 * double(c.y) + 0.0722 * double(c.z); }

std::vector<Star> const& whole_sky() {
    static std::vector<Star> const stars = [] {
        std::vector<Star> found;
        int const n = int(1.02f / STAR_CELL) + 1;
        for (int z = -n; z <= n; ++z)
            for (int y = -n; y <= n; ++y)
                for (int x = -n; x <= n; ++x)
                    if (Star const star = star_of_cell({x, y, z}); star.irradiance.y > 0) found.push_back(star);
        return found;
    }();
    return stars;
}

double magnitude(Star const& star) { return -26.74 - 2.5 * std::log10(luminance_of(star.irradiance)); }

ViewPixel pixel_at(double x, double y, int width, int height, double fov) {
    double const step = 2 * std::tan(0.5 * fov) / height;
    glm::dvec3 const axis = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
    glm::dvec3 const right = glm::normalize(glm::cross(axis, glm::dvec3(0, 0, 1))), down = glm::cross(axis, right);
    glm::dvec3 const along = axis + (x + 0.5 - 0.5 * width) * step * right + (y + 0.5 - 0.5 * height) * step * down;
    return {vec3(axis), vec3(along), vec3(step * right), vec3(step * down)};
}

} // namespace

// Hipparcos' counts: OEIS A053406.
TEST(Stars, there_are_as_many_of_each_magnitude_as_in_the_sky) {
    constexpr std::array COUNTS{15.0, 49.0, 172.0, 511.0, 1600.0, 4968.0}; // brighter than 1, 2, ... 6
    for (std::size_t i = 0; i < COUNTS.size(); ++i) {
        double count = 0;
        for (Star const& star : whole_sky()) count += magnitude(star) < double(i + 1);
        // The law is within 10 % of the counts; four standard deviations of chance.
        EXPECT_NEAR(count, COUNTS[i], 0.1 * COUNTS[i] + 4 * std::sqrt(COUNTS[i])) << "brighter than " << i + 1;
    }
    EXPECT_NEAR(double(whole_sky().size()), 9000, 4 * 95);
}

// All stars to 6.5 together are as bright as 100 of magnitude 0 (Sky and Telescope).
TEST(Stars, together_they_are_as_bright_as_the_skys) {
    double sum = 0;
    for (Star const& star : whole_sky()) sum += luminance_of(star.irradiance);
    EXPECT_NEAR(sum / std::pow(10, -0.4 * 26.74), 110, 20);
}

TEST(Stars, are_spread_evenly_over_the_sphere) {
    glm::dvec3 mean(0);
    glm::dmat3 second(0);
    for (Star const& star : whole_sky()) {
        glm::dvec3 const d(star.direction);
        EXPECT_NEAR(glm::length(d), 1, 1e-6);
        mean += d / double(whole_sky().size());
        second += glm::outerProduct(d, d) / double(whole_sky().size());
    }
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(mean[i], 0, 4 * 0.577 / 95); // four standard deviations of 9000 even directions
        EXPECT_NEAR(second[i][i], 1.0 / 3, 4 * 0.298 / 95);
        EXPECT_NEAR(second[i][(i + 1) % 3], 0, 4 * 0.258 / 95);
    }
}

TEST(Stars, a_pictures_pixels_hold_all_their_light_at_any_resolution) {
    double const fov = glm::radians(30.0);
    for (int const height : {30, 60, 200}) {
        double seen = 0, expected = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < height; ++x) {
                ViewPixel const pixel = pixel_at(x, y, height, height, fov);
                seen += luminance_of(star_radiance(pixel, true)) * double(solid_angle(pixel));
            }
        // A star near the edge gives what its tent leaves inside: stand in for it by summing the same shares, star by star.
        ViewPixel const middle = pixel_at(0.5 * height - 0.5, 0.5 * height - 0.5, height, height, fov);
        for (Star const& star : whole_sky()) {
            double const depth = glm::dot(glm::dvec3(star.direction), glm::dvec3(middle.centre));
            if (depth < 0.5) continue;
            glm::dvec3 const offset = glm::dvec3(star.direction) / depth - glm::dvec3(middle.along);
            auto const inside = [&](glm::dvec3 const& axis) {
                double const p = glm::dot(offset, axis) / glm::dot(axis, axis) + 0.5 * height; // [pixels] from the edge
                return std::clamp(std::min(p + 0.5, height - p + 0.5), 0.0, 1.0);
            };
            expected += luminance_of(star.irradiance) * inside(glm::dvec3(middle.right)) * inside(glm::dvec3(middle.down));
        }
        // Float positions of 1e-7 in pixels of 1e-3.
        EXPECT_NEAR(seen / expected, 1, 2e-3) << height;
    }
}

TEST(Stars, a_star_that_moves_by_a_part_of_a_pixel_keeps_its_light) {
    for (double shift = 0; shift < 1; shift += 0.13) {
        double share = 0;
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x) {
                vec3 const right(1e-3f, 0, 0), down(0, -1e-3f, 0);
                ViewPixel const pixel{{0, 0, -1}, {float(x) * 1e-3f, float(y) * -1e-3f, -1}, right, down};
                share += double(star_share(pixel, glm::normalize(vec3(float(shift) * 1e-3f, 0.4e-3f, -1))));
            }
        EXPECT_NEAR(share, 1, 1e-4) << shift;
    }
}
