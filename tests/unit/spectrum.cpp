#include "scene/air.h"
#include "scene/spectrum.h"

#include <gtest/gtest.h>

using namespace alpenglow;

TEST(Spectrum, rayleigh_falls_with_the_fourth_power) {
    glm::dvec3 const canonical = rayleigh_scattering(CANONICAL_WAVELENGTHS);
    glm::dvec3 const published{5.802e-6, 13.558e-6, 33.100e-6}; // Bruneton 2017, Hillaire 2020
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(canonical[i], published[i], 1e-3 * published[i]);
    // The wavelengths of Boody and Dereyne.
    glm::dvec3 const others = rayleigh_scattering({650e-9, 510e-9, 475e-9}), expected{6.95e-6, 18.34e-6, 24.37e-6};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(others[i], expected[i], 1e-3 * expected[i]);
}

TEST(Spectrum, ozone_absorbs_orange_most_and_hardly_blue) {
    EXPECT_NEAR(ozone_cross_section(550e-9), 3.5e-25, 1e-39);
    EXPECT_NEAR(ozone_cross_section(555e-9), 0.5 * (3.5e-25 + 4.266e-25), 1e-30);
    EXPECT_GT(ozone_cross_section(600e-9), 30 * ozone_cross_section(440e-9));
    EXPECT_EQ(ozone_cross_section(SHORTEST_WAVELENGTH), 1.18e-27);
    EXPECT_EQ(ozone_cross_section(LONGEST_WAVELENGTH), 7.105e-27);
}

TEST(Spectrum, ozone_of_300_dobson_units_is_the_canonical_one) {
    glm::dvec3 const absorption = ozone_absorption(300, 15000, CANONICAL_WAVELENGTHS);
    glm::dvec3 const published{0.650e-6, 1.881e-6, 0.085e-6};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(absorption[i], published[i], 1e-3 * published[i]);
}

TEST(Profiles, have_the_columns_of_their_areas) {
    EXPECT_DOUBLE_EQ(profile_column(tent_profile(25000, 15000), 1e5), 15000);
    EXPECT_NEAR(profile_column(tent_profile(25000, 15000), 25000), 7500, 1e-9);
    EXPECT_NEAR(profile_column(tent_profile(1000, 2000), 1e5), 1750, 1e-9); // cut by the ground
    EXPECT_DOUBLE_EQ(profile_column(shell_profile(3000, 5000), 1e5), 2000);
    EXPECT_NEAR(profile_column(ExponentialProfile{8000}, 1e5), 8000 * (1 - std::exp(-12.5)), 1e-9);
    LinearProfile const table{{{0, 0.5}, {1000, 1}, {1000, 2}, {3000, 0}}};
    EXPECT_NEAR(profile_column(table, 1e5), 750 + 2000, 1e-9);
}

TEST(Profiles, have_a_piece_for_each_slope_and_step) {
    EXPECT_EQ(piece_count(ExponentialProfile{}), 0u);
    EXPECT_EQ(piece_count(tent_profile(25000, 15000)), 2u);
    EXPECT_EQ(piece_count(shell_profile(3000, 5000)), 2u);
    EXPECT_EQ(piece_count(LinearProfile{{{0, 0.5}, {1000, 1}, {1000, 2}, {2000, 2}, {3000, 0}}}), 4u);
}
