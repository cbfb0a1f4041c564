#include "reference/picture.h"
#include "support/traced_world.h"

#include <gtest/gtest.h>

using namespace alpenglow;
using namespace alpenglow::test;

namespace {

Extent const SIZE = long_proofs() ? Extent{32, 24} : Extent{8, 6};
/// Enough for variances that a chi-square can use: their own error makes it (n - 1) / (n - 3) too large.
constexpr int PASSES = 24;

/// From 2 km over a low sun: sky, horizon and ground.
Camera camera(Planet const& planet) {
    return {.position = {0, 0, planet.radius + 2000},
            .world_from_camera = world_from_camera_ahead({1, 0, 0}, {0, 0, 1}, 0.3, 0)};
}

Planet earth(double rayleigh = 1) {
    Planet planet = make_earth();
    planet.look = GroundLook::uniform;
    planet.air.at("rayleigh").scattering *= rayleigh;
    return planet;
}

LightSource low_sun(Planet const& planet) {
    double const elevation = glm::radians(12.0), azimuth = glm::radians(50.0);
    return {.to_sun = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                       std::sin(elevation)},
            .angular_radius = planet.sun_angular_radius};
}

TracedPicture picture(Planet const& planet, std::uint64_t seed, int threads, int passes) {
    TracedWorld const world(planet, low_sun(planet), 0);
    TracedPicture result(SIZE);
    for (int pass = 0; pass < passes; ++pass) result.add_pass(world.tracer, camera(planet), seed, threads);
    return result;
}

ChiSquare difference(TracedPicture const& a, TracedPicture const& b) {
    double const too_large = (PASSES - 1.0) / (PASSES - 3.0);
    ChiSquare sum;
    for (std::size_t i = 0; i < SIZE.pixels(); ++i)
        sum.add(a.mean(i).z - b.mean(i).z, (a.variance(i).z + b.variance(i).z) * too_large);
    return sum;
}

TracedPicture const& first() {
    static TracedPicture const traced = picture(earth(), 1, 1, PASSES);
    return traced;
}

} // namespace

TEST(ReferencePicture, two_seeds_agree_within_their_variances) {
    ChiSquare const same = difference(first(), picture(earth(), 2, 1, PASSES));
    EXPECT_EQ(same.degrees, static_cast<int>(SIZE.pixels()));
    EXPECT_GT(same.tail(), 1e-3);
    EXPECT_LT(same.tail(), 1 - 1e-3); // nor are the variances too large
}

TEST(ReferencePicture, three_percent_more_rayleigh_disagrees) {
    EXPECT_LT(difference(first(), picture(earth(1.03), 2, 1, PASSES)).tail(), 1e-6);
}

TEST(ReferencePicture, is_the_same_for_any_number_of_threads) {
    TracedPicture const one = picture(earth(), 3, 1, 2), two = picture(earth(), 3, 2, 2),
                        other = picture(earth(), 4, 2, 2);
    EXPECT_EQ(one.state(), two.state());
    EXPECT_NE(one.state(), other.state());
}

TEST(ReferencePicture, goes_on_from_a_stored_state_as_if_never_stopped) {
    TracedPicture const whole = picture(earth(), 5, 1, 3), part = picture(earth(), 5, 1, 2);
    Planet const planet = earth();
    TracedWorld const world(planet, low_sun(planet), 0);
    TracedPicture resumed(SIZE);
    resumed.restore(part.state());
    resumed.add_pass(world.tracer, camera(planet), 5, 1);
    EXPECT_EQ(resumed.state(), whole.state());
}
